#include "decimate/frames.hpp"

#include <cstring>

namespace winnow {

Frames::Frames(const TileMesh& mesh, std::span<const std::byte> state, std::size_t frames,
               bool before_collapses)
    : frames_(frames), position_(frames * mesh.vertex_count()) {
  const std::size_t later = first_state_size(frames);
  const std::size_t size = before_collapses ? later : state_size(frames);
  if (!before_collapses) witness_.resize(position_.size());
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    Point* const positions = position_.data() + v * frames;
    const std::byte* const bytes = state.data() + v * size;
    positions[0] = mesh.position(v);
    if (later > 0) std::memcpy(positions + 1, bytes, later);
    if (!before_collapses)
      std::memcpy(witness_.data() + v * frames, bytes + later, frames * sizeof(Point));
  }
  if (before_collapses) witness_ = position_;
}

void Frames::save(VertexNumber v, std::byte* into) const {
  const std::size_t later = first_state_size(frames_);
  if (later > 0) std::memcpy(into, positions(v).data() + 1, later);
  std::memcpy(into + later, witnesses(v).data(), frames_ * sizeof(Point));
}

}  // namespace winnow
