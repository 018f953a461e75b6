// The types of numbers in arrays and files.
#pragma once

#include <cstdint>

namespace winnow {

enum class NumberType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

}  // namespace winnow
