// OBJ, OFF and .m files in many styles.
#pragma once

#include "support/polygons.hpp"

#include <string>
#include <utility>
#include <vector>

namespace winnow::test {

// Where `random` is given: everything that a format allows besides, anywhere.
struct TextStyle {
  std::string line_end = "\n";
  Random* random = nullptr;
};

// Positions in the fewest digits that give the same double back. A corner -1 names no vertex.
std::string obj_file(const Polygons& mesh, const TextStyle& style);
std::string off_file(const Polygons& mesh, const TextStyle& style,
                     const std::string& keyword = "OFF");
// With `random` vertices have scattered numbers, stand in any order, and faces stand between them.
std::string m_file(const Polygons& mesh, const TextStyle& style);

// The same mesh with its coordinates as floats.
Polygons as_floats(Polygons mesh);

}  // namespace winnow::test
