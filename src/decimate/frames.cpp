#include "decimate/frames.hpp"

#include <cstring>

namespace winnow {

Frames::Frames(const TileMesh& mesh, std::span<const std::byte> state, std::size_t state_size,
               std::size_t frames)
    : frames_(frames), position_(frames * mesh.vertex_count()) {
  const std::size_t later = saved_size(frames);
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    Point* const positions = position_.data() + v * frames;
    positions[0] = mesh.position(v);
    if (later > 0) std::memcpy(positions + 1, state.data() + v * state_size, later);
  }
}

void Frames::save(VertexNumber v, std::byte* into) const {
  const std::size_t later = saved_size(frames_);
  if (later > 0) std::memcpy(into, positions(v).data() + 1, later);
}

}  // namespace winnow
