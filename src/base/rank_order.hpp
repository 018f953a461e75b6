// Sorting by whole numbers, without comparing them.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

// Its memory serves one sort after the other. Up to 2^32 things at a time.
class RankOrder {
 public:
  struct Place {
    std::uint64_t rank;
    std::uint32_t number;
  };
  static constexpr std::uint64_t bytes_a_place = 2 * sizeof(Place);

  // The numbers below `count` in the order of rank_of(number), and where ranks are equal, of
  // before(number, number). Valid until the next call. As fast for any order as the numbers' caches
  // allow: by the 33 highest bits that differ in three passes, and what is equal then by comparing.
  template <typename RankOf, typename Before>
  std::span<const Place> sort(std::size_t count, const RankOf& rank_of, const Before& before) {
    places_.resize(count);
    other_.resize(count);
    std::uint64_t differing = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      places_[i] = {rank_of(i), i};
      differing |= places_[i].rank ^ places_[0].rank;
    }
    const auto bits = static_cast<unsigned>(std::bit_width(differing));
    const unsigned low = bits > passes * digit_bits ? bits - passes * digit_bits : 0;
    for (unsigned shift = low; shift < bits; shift += digit_bits) {
      if ((differing >> shift & (digits - 1)) != 0) pass(shift);
    }
    for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
      const std::uint64_t high = places_[begin].rank >> low;
      for (end = begin + 1; end < count && places_[end].rank >> low == high;) ++end;
      if (end - begin == 1) continue;
      std::sort(places_.begin() + static_cast<std::ptrdiff_t>(begin),
                places_.begin() + static_cast<std::ptrdiff_t>(end),
                [&](const Place& a, const Place& b) {
                  return a.rank != b.rank ? a.rank < b.rank : before(a.number, b.number);
                });
    }
    return places_;
  }

 private:
  static constexpr unsigned digit_bits = 11;
  static constexpr std::size_t digits = std::size_t{1} << digit_bits;
  static constexpr unsigned passes = 3;

  void pass(unsigned shift) {
    std::array<std::uint32_t, digits> begin{};
    const auto digit = [shift](const Place& place) { return place.rank >> shift & (digits - 1); };
    for (const Place& place : places_) ++begin[digit(place)];
    std::uint32_t sum = 0;
    for (std::uint32_t& at : begin) sum += std::exchange(at, sum);
    for (const Place& place : places_) other_[begin[digit(place)]++] = place;
    places_.swap(other_);
  }

  std::vector<Place> places_, other_;
};

}  // namespace winnow
