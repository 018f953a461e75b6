// What an edge costs in each frame of a sequence, by the planes that its ends stand for.
#pragma once

#include "decimate/beside_collapse.hpp"
#include "decimate/decimation.hpp"
#include "decimate/frames.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

// One edge, frame by frame.
struct EdgeInFrames {
  explicit EdgeInFrames(std::size_t frames) : costs(frames), to(frames), flat(frames) {}

  std::vector<double> costs;
  std::vector<Point> to;           // its best places
  std::vector<std::uint8_t> flat;  // goes to an end where nothing is lost
};

class FrameQuadrics {
 public:
  virtual ~FrameQuadrics() = default;

  virtual void evaluate(VertexNumber low, VertexNumber high, EdgeInFrames& edge) = 0;
  // What is lost in a frame where both ends go there.
  [[nodiscard]] virtual double cost_at(VertexNumber kept, VertexNumber removed, std::size_t frame,
                                       const Point& to) const = 0;
  // The weight of all planes of a vertex.
  [[nodiscard]] virtual double weight(VertexNumber v, std::size_t frame) const = 0;
  // Raises the costs of a legal collapse where a closer look finds more. Whether it does.
  virtual bool look_closer(const Collapse& collapse, const EdgeStar& star, EdgeInFrames& edge) = 0;

  // Told before and after the collapse of the edge that was looked at last.
  virtual void collapsing(const Collapse& collapse, EdgeStar& star, const EdgeInFrames& edge,
                          const BesideCollapse& beside) = 0;
  virtual void collapsed(const Collapse& collapse, const BesideCollapse& beside) = 0;

  // Writes what is remembered of a vertex: remembered_size() bytes.
  virtual void save(VertexNumber v, std::byte* into) const = 0;
};

// Those of SequenceSettings::accumulated, or not. `state`: state_size bytes of each vertex, which
// end with what save() wrote, or of which none are those: before the first collapse. `frames` must
// stay.
std::unique_ptr<FrameQuadrics> make_frame_quadrics(TileMesh& mesh, const Frames& frames,
                                                   std::span<const std::byte> state,
                                                   const DecimationSettings& settings);
std::unique_ptr<FrameQuadrics> make_memoryless_quadrics(TileMesh& mesh, const Frames& frames,
                                                        std::span<const std::byte> state,
                                                        const DecimationSettings& settings);
std::unique_ptr<FrameQuadrics> make_accumulated_quadrics(TileMesh& mesh, const Frames& frames,
                                                         std::span<const std::byte> state,
                                                         const DecimationSettings& settings);

// Bytes that a vertex takes to remember, and in use at the most.
std::size_t remembered_size(const SequenceSettings& settings);
std::uint64_t quadrics_memory(const SequenceSettings& settings, std::uint64_t vertices);

}  // namespace winnow
