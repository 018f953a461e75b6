// PLY files in every style there is.
#pragma once

#include "read/ply/header.hpp"
#include "support/polygons.hpp"

#include <array>
#include <string>

namespace winnow::test {

struct PlyStyle {
  PlyForm form = PlyForm::little_endian;
  PlyType count = PlyType::uint8;
  PlyType index = PlyType::int32;
  std::array<PlyType, 3> coordinate{PlyType::float32, PlyType::float32, PlyType::float32};
  std::string list = "vertex_indices";
  std::string faces = "face";  // or "tristrips"
  std::string line_end = "\n";
  bool new_names = false;  // "float32" instead of "float"
  bool faces_first = false;
  // Where given: comments, properties (lists too) and elements that nobody asked for, in any order.
  Random* ornaments = nullptr;
};

std::string ply_file(const Polygons& mesh, const PlyStyle& style);

// A style of random choices that can hold the mesh.
PlyStyle random_ply_style(Random& random, const Polygons& mesh);

// The mesh as the types of the style hold it.
Polygons as_stored(Polygons mesh, const PlyStyle& style);

// Whole numbers first.
inline constexpr std::array ply_types{PlyType::int8,    PlyType::uint8,  PlyType::int16,
                                      PlyType::uint16,  PlyType::int32,  PlyType::uint32,
                                      PlyType::float32, PlyType::float64};
inline constexpr std::size_t whole_types = 6;

std::string type_name(PlyType type, bool new_names);

}  // namespace winnow::test
