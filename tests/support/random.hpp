// Random numbers that are the same in every run.
#pragma once

#include "base/wide.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace winnow::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  std::uint64_t below(std::uint64_t bound) { return scaled_hash(engine_(), bound); }
  std::uint64_t between(std::uint64_t low, std::uint64_t high) {
    return low + below(high - low + 1);
  }
  bool chance(double p) { return unit() < p; }
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  // from 0 to below 1
  double real(double low, double high) { return low + (high - low) * unit(); }

  template <typename T>
  void shuffle(std::vector<T>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

  template <typename T>
  const T& one_of(const std::vector<T>& values) {
    return values[below(values.size())];
  }

  // Bytes that compress a little, as those of meshes do.
  std::string bytes(std::size_t count) {
    std::string text(count, '\0');
    for (char& c : text) c = static_cast<char>(bits() >> 56 & (chance(0.5) ? 0xff : 0x0f));
    return text;
  }

  // Parts of at most `most` that add up to `total`.
  std::vector<std::size_t> parts(std::size_t total, std::size_t most) {
    std::vector<std::size_t> sizes;
    for (std::size_t left = total; left > 0; left -= sizes.back()) {
      sizes.push_back(std::min<std::size_t>(
          left, between(1, chance(0.2) ? std::min<std::size_t>(most, 3) : most)));
    }
    return sizes;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace winnow::test
