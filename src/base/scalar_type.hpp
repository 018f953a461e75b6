// The types of single numbers in mesh files.
#pragma once

#include <cstddef>
#include <cstdint>

namespace winnow {

enum class ScalarType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(ScalarType type);
bool is_integer(ScalarType type);
const char* name_of(ScalarType type);  // "uchar", "float": as PLY calls it

// Writes the number of the type that is nearest to `value`, and so the lowest or the highest one where that
// is beyond. Of what is not finite a real type keeps what it is; no number is 0 as a whole one.
void store_rounded(double value, ScalarType type, std::byte* at);

}  // namespace winnow
