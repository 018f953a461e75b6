// Costs by their first bits: those of a class differ by less than a sixteenth.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace winnow {

inline constexpr unsigned cost_class_bits = 48;
inline constexpr std::size_t cost_classes = std::size_t{1} << (63 - cost_class_bits);  // no sign

// Of a cost that is not below 0.
inline std::uint32_t cost_class(double cost) {
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(cost + 0.0) >> cost_class_bits);
}

inline double least_of_cost_class(std::size_t number) {
  return std::bit_cast<double>(std::uint64_t{number} << cost_class_bits);
}

}  // namespace winnow
