// A scattered order that needs no memory.
#pragma once

#include <cstdint>

namespace winnow {

// A permutation of 0 .. count-1, computed number by number: a Feistel network over the next power
// of two, walked along its cycles until it falls below the count (Black and Rogaway, "Ciphers with
// Arbitrary Finite Domains", 2002).
class Scatter {
 public:
  Scatter(std::uint64_t count, std::uint64_t seed);

  [[nodiscard]] std::uint64_t operator()(std::uint64_t number) const;

 private:
  std::uint64_t count_;
  std::uint64_t seed_;
  unsigned low_bits_, high_bits_;
};

}  // namespace winnow
