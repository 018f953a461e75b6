// What plain and compressed GLB share: how a vertex is laid out, where a mesh is moved to, and the
// JSON that says what the bytes are.
#pragma once

#include "write/mesh_encoder.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace winnow {

// GLB holds floats. A mesh of doubles that lies far from the origin is therefore written from a
// place near it, which its node carries back: on each axis the lower side of its box, rounded down
// to a multiple of the largest power of two that is not above the longest side, so that the steps
// of floats are small beside the mesh. A mesh within twice its size of the origin, and one of
// floats, stays where it is.
Point glb_offset(const MeshShape& shape);

// The types of components, by the specification.
enum class GlbType : unsigned {
  int8 = 5120,
  uint8 = 5121,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

std::uint64_t size_of(GlbType type);

// Numbers that a vertex has, `offset` bytes behind its first.
struct GlbPart {
  GlbType type = GlbType::float32;
  unsigned components = 3;
  std::uint64_t offset = 0;
};

// What its node does to a position: it is scaled, turned and moved.
struct GlbPlace {
  Point offset{};  // that positions are written from, ...
  std::optional<double>
      step;  // ... in multiples of this, from 0 to `highest`, if they are whole numbers
  double highest = 0;
  bool z_up = false;

  // By which rounding to whole numbers moves a position at most; 0 without.
  [[nodiscard]] double error() const;
};

// Each part of a vertex begins at a whole word. Colours are of light, not as sRGB has it, and of
// the smallest type from which each number of the input's type comes back as it was: 8 bits hold
// light of 8 bits, 16 bits light of 16 and colours of 8 (of which 8 bits would lose the dark ones),
// floats all others.
struct GlbLayout {
  GlbLayout(const MeshShape& shape, const Encoding& encoding);

  GlbPart position;
  std::optional<GlbPart> normal, color;
  std::uint64_t stride = 0;
  GlbPlace place;
};

void append_glb_vertices(const MeshShape& shape, const GlbLayout& layout,
                         std::span<const MeshVertex> vertices, std::vector<std::byte>& out);

// As they are written: a position, a normal as long as 1, a box of positions.
Point written_position(const Point& position, const GlbLayout& layout);
std::array<float, 3> unit_normal(const std::array<float, 3>& normal);
Box written_box(const Box& box, const GlbLayout& layout);

// Of indices in a primitive of so many vertices, 0 if that is not known: the largest number of a
// type is no index.
constexpr GlbType index_type_for(std::uint64_t vertices) {
  return vertices > 0 && vertices <= UINT16_MAX ? GlbType::uint16 : GlbType::uint32;
}

// Views begin at whole words.
constexpr std::uint64_t whole_words(std::uint64_t bytes) {
  return (bytes + 3) / 4 * 4;
}

// All before the bytes of the blocks, which are, of each, its vertices and its indices, both filled
// up to whole words. Each block is a primitive of the one mesh. Of `packed` blocks the bytes are
// those of EXT_meshopt_compression. With a `motion` there is one block, which is not packed, and
// the bytes of the motion stand behind it. Throws Error(usage) beyond 4 GiB.
using Emit = std::function<void(std::string_view)>;
struct GlbMotion;
void emit_glb_head(const MeshShape& shape, const GlbLayout& layout,
                   std::span<const MeshBlock> blocks, bool packed, const Emit& emit,
                   const GlbMotion* motion = nullptr);

[[noreturn]] void refuse_glb_size(std::uint64_t faces);

// With EXT_meshopt_compression.
std::unique_ptr<MeshEncoder> make_packed_glb_encoder(const Encoding& encoding);

}  // namespace winnow
