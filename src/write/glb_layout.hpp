// What plain and compressed GLB share: where a mesh is moved to, and the JSON that says what the bytes are.
#pragma once

#include "write/mesh_encoder.hpp"

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace winnow {

// GLB holds floats. A mesh of doubles that lies far from the origin is therefore written from a place
// near it, which its node carries back: on each axis the lower side of its box, rounded down to a multiple
// of the largest power of two that is not above the longest side, so that the steps of floats are small
// beside the mesh. A mesh within twice its size of the origin, and one of floats, stays where it is.
Point glb_offset(const MeshShape& shape);

// Bytes of a vertex: its position and, if the shape has them, its normal and its colour, three or four
// floats, of light, not as sRGB has it.
std::uint64_t glb_stride(const MeshShape& shape);
void append_glb_vertices(const MeshShape& shape, const Point& offset, std::span<const MeshVertex> vertices,
                         std::vector<std::byte>& out);

// A box of positions as they are written, from `offset`.
Box written_box(const Box& box, const Point& offset);

// What is packed begins at whole words.
constexpr std::uint64_t whole_words(std::uint64_t bytes) {
  return (bytes + 3) / 4 * 4;
}

// All before the bytes of the blocks, whose positions are from glb_offset(). Each block is a primitive of the
// one mesh. Of `packed` blocks the bytes are those of EXT_meshopt_compression. Throws Error(usage) beyond 4
// GiB.
using Emit = std::function<void(std::string_view)>;
void emit_glb_head(const MeshShape& shape, std::span<const MeshBlock> blocks, bool packed, const Emit& emit);

// Throws Error(usage) where floats do not reach.
void check_floats(const Box& box);

[[noreturn]] void refuse_glb_size(std::uint64_t faces);

}  // namespace winnow
