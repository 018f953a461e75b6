// What a PLY header tells of faces and attributes.
#pragma once

#include "read/mesh_reader.hpp"
#include "read/ply/header.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace winnow {

InputFacts ply_facts(const PlyHeader& header);
AvailableAttributes available_attributes(const PlyHeader& header);

// The element that holds the faces; without one where the file has none.
struct PlyFaces {
  const PlyElement* element = nullptr;
  const PlyProperty* list = nullptr;
  bool strips = false;
};

// Throws Error(bad_input) where they have no indices; `name`: of the file.
PlyFaces find_faces(const PlyHeader& header, const std::string& name);

// Size of a face's record if it is a triangle and nothing but the list has a variable size, and the
// list has the types that nearly every file uses; else 0.
std::size_t triangle_stride(const PlyHeader& header, const PlyFaces& faces);

// Whether all faces are triangles, by the size of the whole.
bool surely_triangles(const PlyHeader& header, const PlyFaces& faces,
                      std::optional<std::uint64_t> size);

}  // namespace winnow
