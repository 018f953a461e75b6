// The faces around a vertex, as who encodes a split has them and as who decodes it. A file counts
// them in the order of their other corners.
#pragma once

#include "progressive/split.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace winnow {

// Around anchors with more faces these are told of one by one.
inline constexpr std::size_t most_ring_faces = 128;

// Fixed arrays side by side, so that a few faces are compared at once: most rings have six.
class Ring {
 public:
  void clear() { count_ = 0; }
  // No more than one face above most_ring_faces.
  void add(const FarEdge& far, std::uint32_t corner = no_number) {
    first_[count_] = far[0];
    second_[count_] = far[1];
    corner_[count_++] = corner;
  }
  [[nodiscard]] bool full() const { return count_ > most_ring_faces; }

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::uint32_t first(std::size_t i) const { return first_[i]; }
  [[nodiscard]] std::uint32_t second(std::size_t i) const { return second_[i]; }
  // In a SplitMesh, where it is known.
  [[nodiscard]] std::uint32_t corner(std::size_t i) const { return corner_[i]; }

  void sort() {
    std::array<std::uint32_t, capacity> order{};
    sort_places(order);
    const Ring before = *this;
    for (std::size_t i = 0; i < count_; ++i) {
      first_[i] = before.first_[order[i]];
      second_[i] = before.second_[order[i]];
      corner_[i] = before.corner_[order[i]];
    }
  }

  // The place of the face that is this one, or that has so many before it in their order; size()
  // where there is none.
  [[nodiscard]] std::size_t place_of(const FarEdge& far) const {
    std::size_t i = 0;
    while (i < count_ && (first_[i] != far[0] || second_[i] != far[1])) ++i;
    return i;
  }
  [[nodiscard]] std::size_t place_of(std::size_t rank) {
    if (rank >= count_) return count_;
    std::size_t place = 0, found = 0;
    fill_up();
    const std::size_t padded = (count_ + lanes - 1) / lanes * lanes;
    for (std::size_t begin = 0; begin < count_; begin += lanes) {
      std::array<std::uint32_t, lanes> before{};
      // As often for most rings.
      for (std::size_t k = 0; k < padded; ++k) {
        for (std::size_t lane = 0; lane < lanes; ++lane)
          before[lane] += first_[k] < first_[begin + lane] ? 1 : 0;
      }
      const std::size_t end = std::min(lanes, count_ - begin);
      for (std::size_t lane = 0; lane < end; ++lane) {
        place = before[lane] == rank ? begin + lane : place;
        found += before[lane] == rank ? 1 : 0;
      }
    }
    if (found == 1) return place;
    std::array<std::uint32_t, capacity> order{};
    sort_places(order);
    return order[rank];
  }

  // How many faces come before the one at `place` in their order.
  [[nodiscard]] std::size_t rank_of(std::size_t place) const {
    const std::uint32_t first = first_[place], second = second_[place];
    std::size_t before = 0;
    for (std::size_t k = 0; k < count_; ++k)
      before += (first_[k] < first) | ((first_[k] == first) & (second_[k] < second)) ? 1 : 0;
    return before;
  }

  // All different corners beside the vertex, in ascending order.
  void find_neighbours(std::vector<std::uint32_t>& out) const {
    out.assign(first_.begin(), first_.begin() + static_cast<std::ptrdiff_t>(count_));
    out.insert(out.end(), second_.begin(), second_.begin() + static_cast<std::ptrdiff_t>(count_));
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
  }

  // The faces side by side from the one at `begin` on, by their places: no more than `most`, and no
  // further than to the end of the fan, or to where a neighbour has two faces that could be the
  // next.
  void walk(std::size_t begin, std::size_t most, std::vector<std::uint32_t>& places) {
    fill_up();
    places.clear();
    places.push_back(static_cast<std::uint32_t>(begin));
    while (places.size() < most) {
      const std::uint32_t from = second_[places.back()];
      std::uint32_t next = 0, found = 0;
      for (std::size_t part = 0; part < count_; part += lanes) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          const bool follows = first_[part + lane] == from;
          next += follows ? static_cast<std::uint32_t>(part + lane) : 0;
          found += follows ? 1 : 0;
        }
      }
      if (found != 1) return;
      if (std::find(places.begin(), places.end(), next) != places.end()) return;
      places.push_back(next);
    }
  }

 private:
  static constexpr std::size_t lanes = 8;
  static constexpr std::size_t capacity = (most_ring_faces / lanes + 1) * lanes;
  using List = std::array<std::uint32_t, capacity>;

  // Up to whole lanes with what is no vertex.
  void fill_up() {
    for (std::size_t i = count_; i % lanes != 0; ++i) first_[i] = no_number;
  }
  void sort_places(List& order) const {
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(count_);
    std::iota(order.begin(), end, 0);
    std::sort(order.begin(), end, [this](std::uint32_t a, std::uint32_t b) {
      if (first_[a] != first_[b]) return first_[a] < first_[b];
      return second_[a] != second_[b] ? second_[a] < second_[b] : corner_[a] < corner_[b];
    });
  }

  List first_, second_, corner_;
  std::size_t count_ = 0;
};

}  // namespace winnow
