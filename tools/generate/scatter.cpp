#include "generate/scatter.hpp"

#include "base/hash.hpp"

#include <bit>

namespace winnow {

Scatter::Scatter(std::uint64_t count, std::uint64_t seed) : count_(count), seed_(mixed_hash(seed)) {
  const auto bits = static_cast<unsigned>(std::bit_width(count > 1 ? count - 1 : 1));
  low_bits_ = bits / 2;
  high_bits_ = bits - low_bits_;
}

std::uint64_t Scatter::operator()(std::uint64_t number) const {
  const std::uint64_t low_mask = (std::uint64_t{1} << low_bits_) - 1;
  const std::uint64_t high_mask = (std::uint64_t{1} << high_bits_) - 1;
  // Each half is changed by a function of the other alone, so every step can be undone: no two
  // numbers ever meet. Four rounds pass for random (Luby and Rackoff, 1988).
  do {
    std::uint64_t low = number & low_mask;
    std::uint64_t high = number >> low_bits_;
    for (std::uint64_t round = 0; round < 4; round += 2) {
      high ^= mixed_hash(seed_ + low * 4 + round) & high_mask;
      low ^= mixed_hash(seed_ + high * 4 + round + 1) & low_mask;
    }
    number = high << low_bits_ | low;
  } while (number >= count_);
  return number;
}

}  // namespace winnow
