// What is in the arrays of a caller.
#pragma once

#include <winnow/mesh.hpp>

#include "base/attribute.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// Throw Error, usage or bad_input, naming the array, where the arrays are not those of a mesh, or
// of a part of one, which may lack any of them.
void check_view(const MeshView& mesh);
void check_batch(const MeshView& mesh);

// What the vertices carry.
std::vector<Attribute> attributes_of(const MeshView& mesh);

// Three numbers a face; those that no vertex can have become 2^32 - 1.
void load_faces(const Rows<3>& faces, std::uint64_t first, std::size_t count,
                std::uint32_t* corners);

}  // namespace winnow
