// Reproducible numbers from a seed.
#pragma once

#include "base/hash.hpp"

#include <cstdint>

namespace winnow {

class SeedStream {
 public:
  explicit SeedStream(std::uint64_t seed) : state_(mixed_hash(seed)) {}

  std::uint32_t bits() { return static_cast<std::uint32_t>(next() >> 32); }

  // Uniform in [low, high).
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11) * (1.0 / 9007199254740992.0));
  }

 private:
  std::uint64_t next() { return mixed_hash(state_++); }

  std::uint64_t state_;
};

}  // namespace winnow
