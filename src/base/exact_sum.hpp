// Sums of doubles without any rounding on the way, so that their order does not matter.
#pragma once

#include <array>
#include <cstdint>

namespace winnow {

// A fixed-point number wide enough for every finite double (Kulisch's long accumulator), in 32-bit
// digits whose carries wait in 64 bits. At most 2^31 additions between two calls of merge() or
// value().
class ExactSum {
 public:
  void add(double value);  // finite
  void merge(const ExactSum& other);
  [[nodiscard]] double value() const;  // rounded once; infinite where no double holds it

 private:
  void settle();  // carries forward, so that each digit is below 2^32 again

  static constexpr std::size_t digits = 70;  // 2^-1074 to beyond 2^1100
  std::array<std::int64_t, digits> digit_{};
  std::uint32_t pending_ = 0;
};

}  // namespace winnow
