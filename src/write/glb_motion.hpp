// What a GLB has besides its mesh where that moves: morph targets and animations of their weights.
#pragma once

#include "base/box.hpp"
#include "base/morph_clip.hpp"
#include "write/glb_layout.hpp"
#include "write/vertex_colors.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace winnow {

// Behind the mesh stand, of each target, what is added to each vertex: to its position, and to its
// normal and its colour, which is light, where it has them. Behind these stand the numbers of the
// clips.
struct GlbMotion {
  bool normals = false;
  unsigned colors = 0;  // components of a colour
  std::uint64_t vertices = 0;
  Box at_rest;             // of the mesh, as it is written
  std::vector<Box> moves;  // of each target: what is added to positions, as it is written
  std::vector<MorphClip> clips;

  // Of what one target adds to one vertex.
  [[nodiscard]] std::uint64_t stride() const {
    return ((normals ? 6 : 3) + colors) * sizeof(float);
  }
  [[nodiscard]] std::uint64_t bytes() const;
  // Accessors of the targets come first.
  [[nodiscard]] std::size_t each_accessors() const {
    return 1 + (normals ? 1 : 0) + (colors > 0 ? 1 : 0);
  }
  [[nodiscard]] std::size_t target_accessors() const { return moves.size() * each_accessors(); }
};

// Of the mesh and the head; `motion` must stay, and be whole when the header is made.
std::unique_ptr<MeshEncoder> make_encoder_of(const Encoding& encoding, const GlbMotion& motion);

// Members and entries of the JSON. `first` and `view`: the number of the motion's first accessor,
// or view.
void emit_glb_targets(const GlbMotion& motion, std::size_t first, const Emit& emit);
void emit_motion_accessors(const GlbMotion& motion, std::size_t view, const Emit& emit);
void emit_motion_views(const GlbMotion& motion, std::uint64_t begin, const Emit& emit);
void emit_glb_animations(const GlbMotion& motion, std::size_t first, const Emit& emit);

// What vertices have in a target besides what they have in the mesh.
struct GlbMove {
  std::array<float, 3> position{}, normal{};
  std::array<float, 4> color{};
};
GlbMove glb_move(const GlbLayout& layout, const VertexColors& colors, const MeshVertex& from,
                 const MeshVertex& to);
void append_move(const GlbMotion& motion, const GlbMove& move, std::vector<std::byte>& out);
void append_clips(const GlbMotion& motion, std::vector<std::byte>& out);

}  // namespace winnow
