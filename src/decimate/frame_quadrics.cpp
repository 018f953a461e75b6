#include "decimate/frame_quadrics.hpp"

#include "base/quadric.hpp"

namespace winnow {

std::unique_ptr<FrameQuadrics> make_frame_quadrics(TileMesh& mesh, const Frames& frames,
                                                   std::span<const std::byte> state,
                                                   const DecimationSettings& settings) {
  return settings.sequence->accumulated ? make_accumulated_quadrics(mesh, frames, state, settings)
                                        : make_memoryless_quadrics(mesh, frames, state, settings);
}

std::size_t remembered_size(const SequenceSettings& settings) {
  return settings.frames * (settings.accumulated ? sizeof(Quadric) : sizeof(Point));
}

std::uint64_t quadrics_memory(const SequenceSettings& settings, std::uint64_t vertices) {
  const std::size_t planes = settings.accumulated ? 0 : sizeof(VertexPlanes);
  return vertices * (remembered_size(settings) + settings.frames * planes + 1);
}

}  // namespace winnow
