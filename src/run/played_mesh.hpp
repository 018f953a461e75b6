// What a progressive file shows, as a mesh that can be written.
#pragma once

#include "base/attribute.hpp"
#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"
#include "progressive/split_player.hpp"

#include <cstddef>
#include <span>

namespace winnow {

// What stored_mesh() takes besides while it orders so many.
std::uint64_t ordering_memory(std::uint64_t vertices, std::uint64_t faces);

// Vertices that have a face, in the order of their keys. `carried`: which of the file's attributes
// they have. `normals`: whether they have those of their faces. `scratch`: where they are ordered,
// or null: in memory.
StoredMesh stored_mesh(Job& job, const SplitPlayer& player, std::span<const std::size_t> carried,
                       bool normals, ScratchMemory* scratch);

}  // namespace winnow
