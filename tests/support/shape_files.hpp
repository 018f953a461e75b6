// Shapes as files.
#pragma once

#include "support/shapes.hpp"

#include <string>

namespace winnow::test {

enum class Numbers { floats, doubles };

// As a file of such numbers holds it.
Shape as_stored(Shape shape, Numbers numbers);

// A binary PLY.
std::string ply_of(const Shape& shape, Numbers numbers = Numbers::floats);

}  // namespace winnow::test
