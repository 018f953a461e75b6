// The planes of all faces of the input that a vertex stands for, and the lines of its boundaries,
// never forgotten: with both weights 0 this is deformation-sensitive decimation (Mohr and Gleicher
// 2003).
#include "base/quadric.hpp"
#include "base/rounding.hpp"
#include "decimate/frame_quadrics.hpp"
#include "decimate/quadric_placement.hpp"

#include <algorithm>
#include <cstring>

namespace winnow {

namespace {

class AccumulatedFrames final : public FrameQuadrics {
 public:
  AccumulatedFrames(TileMesh& mesh, const Frames& frames, std::span<const std::byte> state,
                    const DecimationSettings& settings)
      : mesh_(mesh),
        frames_(frames),
        single_(settings.single),
        quadrics_(frames.count() * mesh.vertex_count()),
        of_kept_(frames.count()) {
    if (settings.boundaries_known) {
      const std::size_t size = frames.count() * sizeof(Quadric);
      const std::size_t later = Frames::saved_size(frames.count());
      for (VertexNumber v = 0; v < mesh.vertex_count(); ++v)
        std::memcpy(&quadrics_[at(v, 0)], state.data() + v * (later + size) + later, size);
      return;
    }
    for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
      for (std::size_t t = 0; t < frames.count(); ++t)
        add_face(mesh.face(f), t, settings.rounding_of_positions());
    }
    for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
      for (const VertexNumber w : mesh.open_neighbours(v)) {
        for (std::size_t t = 0; t < frames.count(); ++t)
          quadrics_[at(v, t)].add_line(frames.positions(w)[t] - frames.positions(v)[t],
                                       boundary_line_weight);
      }
    }
  }

  void evaluate(VertexNumber low, VertexNumber high, EdgeInFrames& edge) override {
    const bool stays = mesh_.hub(high);
    for (std::size_t t = 0; t < frames_.count(); ++t) {
      const Point& from = frames_.positions(low)[t];
      const Point& end = frames_.positions(high)[t];
      const Point along = end - from;
      Quadric both = quadrics_[at(low, t)];
      both.add(quadrics_[at(high, t)].from(from - end));
      edge.to[t] = stays ? end : lowest_position(both, placement_pull, from, along, single_);
      edge.costs[t] = std::max(0.0, both.at(edge.to[t] - from)) +
                      edge_length_share * both.weight() * dot(along, along);
      edge.flat[t] = 0;
    }
  }

  [[nodiscard]] double cost_at(VertexNumber kept, VertexNumber removed, std::size_t frame,
                               const Point& to) const override {
    const VertexPlaces places = frames_.places(frame);
    return quadrics_[at(kept, frame)].at(to - places[kept]) +
           quadrics_[at(removed, frame)].at(to - places[removed]);
  }

  [[nodiscard]] double weight(VertexNumber v, std::size_t frame) const override {
    return quadrics_[at(v, frame)].weight();
  }

  bool look_closer(const Collapse& /*collapse*/, const EdgeStar& /*star*/,
                   EdgeInFrames& /*edge*/) override {
    return false;
  }

  void collapsing(const Collapse& collapse, EdgeStar& /*star*/, const EdgeInFrames& edge,
                  const BesideCollapse& /*beside*/) override {
    for (std::size_t t = 0; t < frames_.count(); ++t) {
      const VertexPlaces places = frames_.places(t);
      of_kept_[t] = quadrics_[at(collapse.kept, t)].from(edge.to[t] - places[collapse.kept]);
      of_kept_[t].add(
          quadrics_[at(collapse.removed, t)].from(edge.to[t] - places[collapse.removed]));
    }
  }

  void collapsed(const Collapse& collapse, const BesideCollapse& /*beside*/) override {
    std::copy(of_kept_.begin(), of_kept_.end(), &quadrics_[at(collapse.kept, 0)]);
  }

  void save(VertexNumber v, std::byte* into) const override {
    std::memcpy(into, &quadrics_[at(v, 0)], frames_.count() * sizeof(Quadric));
  }

 private:
  [[nodiscard]] std::size_t at(VertexNumber v, std::size_t frame) const {
    return v * frames_.count() + frame;
  }

  // A third of its area at each corner.
  void add_face(const FaceVertices& face, std::size_t frame, const CoordinateRounding& rounding) {
    const Triangle triangle = frames_.places(frame).triangle(face);
    const Point doubled = doubled_area(triangle);
    if (thinner_than_rounding(triangle, doubled, rounding)) return;
    const double size = length(doubled);
    for (const VertexNumber v : face)
      quadrics_[at(v, frame)].add_plane(1 / size * doubled, {}, size / 6);
  }

  TileMesh& mesh_;
  const Frames& frames_;
  bool single_;
  std::vector<Quadric> quadrics_;  // seen from the vertex; those of a vertex side by side
  std::vector<Quadric> of_kept_;   // after the collapse that is being made
};

}  // namespace

std::unique_ptr<FrameQuadrics> make_accumulated_quadrics(TileMesh& mesh, const Frames& frames,
                                                         std::span<const std::byte> state,
                                                         const DecimationSettings& settings) {
  return std::make_unique<AccumulatedFrames>(mesh, frames, state, settings);
}

}  // namespace winnow
