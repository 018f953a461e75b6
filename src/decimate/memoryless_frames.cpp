// The planes of the faces around a vertex as they are now, and one point of what was collapsed into
// it (witness_points.hpp): quadric_cost.hpp for each frame.
#include "base/instruction_set.hpp"
#include "base/rounding.hpp"
#include "decimate/edge_batch.hpp"
#include "decimate/frame_quadrics.hpp"
#include "decimate/quadric_placement.hpp"
#include "decimate/witness_points.hpp"

#include <algorithm>
#include <cstring>

namespace winnow {

namespace {

double error_at(const VertexPlanes& p, const Point& t) {
  return t[0] * (p.xx * t[0] + p.xy * t[1] + p.xz * t[2]) +
         t[1] * (p.xy * t[0] + p.yy * t[1] + p.yz * t[2]) +
         t[2] * (p.xz * t[0] + p.yz * t[1] + p.zz * t[2]);
}

VertexPlanes planes_of(const Triangle& triangle, const CoordinateRounding& rounding) {
  const Point doubled = doubled_area(triangle);
  VertexPlanes planes;
  if (!thinner_than_rounding(triangle, doubled, rounding))
    add(planes, doubled, 1 / (6 * length(doubled)));
  return planes;
}

class MemorylessFrames final : public FrameQuadrics {
 public:
  MemorylessFrames(TileMesh& mesh, const Frames& frames, std::span<const std::byte> state,
                   const DecimationSettings& settings)
      : mesh_(mesh),
        frames_(frames),
        single_(settings.single),
        rounding_(settings.rounding_of_positions()),
        least_cosine_(settings.least_cosine),
        planes_(frames.count() * mesh.vertex_count()),
        witness_(frames.all_positions()),
        at_boundary_(mesh.vertex_count(), 0),
        evaluate_edges_(best_kernel(WINNOW_KERNELS(edge_kernel))),
        witness_of_kept_(frames.count()),
        planes_of_kept_(frames.count()) {
    for (VertexNumber v = 0; v < mesh.vertex_count(); ++v)
      at_boundary_[v] = !mesh.all_edges_even(v);
    for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
      if (mesh.removed(f)) continue;
      for (std::size_t t = 0; t < frames.count(); ++t) {
        const VertexPlanes of_face = planes_of(frames.places(t).triangle(mesh.face(f)), rounding_);
        for (const VertexNumber v : mesh.face(f)) add(planes(v, t), of_face);
      }
    }
    for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
      if (!at_boundary_[v]) continue;
      for (const VertexNumber w : mesh.open_neighbours(v)) {
        for (std::size_t t = 0; t < frames.count(); ++t)
          add_line(planes(v, t), frames.positions(w)[t] - frames.positions(v)[t],
                   boundary_line_weight);
      }
    }
    if (!settings.boundaries_known) return;
    const std::size_t size = frames.count() * sizeof(Point);
    const std::size_t later = Frames::saved_size(frames.count());
    for (VertexNumber v = 0; v < mesh.vertex_count(); ++v)
      std::memcpy(&witness(v, 0), state.data() + v * (later + size) + later, size);
  }

  // A batch has one edge in several frames.
  void evaluate(VertexNumber low, VertexNumber high, EdgeInFrames& edge) override {
    const std::span<const Point> of_low = frames_.positions(low);
    const std::span<const Point> of_high = frames_.positions(high);
    const bool stays = mesh_.hub(high);
    for (std::size_t first = 0; first < frames_.count(); first += EdgeBatch::capacity) {
      const std::size_t count = std::min(EdgeBatch::capacity, frames_.count() - first);
      for (std::size_t i = 0; i < count; ++i) {
        set_low(batch_, i, of_low[first + i], planes(low, first + i));
        set_high(batch_, i, of_high[first + i], planes(high, first + i), stays);
      }
      evaluate_edges_(batch_, count, single_);
      for (std::size_t i = 0; i < count; ++i) {
        edge.costs[first + i] = batch_.cost[i];
        edge.to[first + i] = position_of(batch_, i);
        edge.flat[first + i] = batch_.flat_low[i] + batch_.flat_high[i] != 0;
      }
    }
  }

  [[nodiscard]] double cost_at(VertexNumber kept, VertexNumber removed, std::size_t frame,
                               const Point& to) const override {
    const VertexPlaces places = frames_.places(frame);
    return error_at(planes_[at(kept, frame)], to - places[kept]) +
           error_at(planes_[at(removed, frame)], to - places[removed]);
  }

  [[nodiscard]] double weight(VertexNumber v, std::size_t frame) const override {
    return weight_of(planes_[at(v, frame)]);
  }

  bool look_closer(const Collapse& collapse, const EdgeStar& star, EdgeInFrames& edge) override {
    const VertexNumber kept = collapse.kept;
    const VertexNumber removed = collapse.removed;
    const bool hub = mesh_.hub(kept);
    bool costlier = false;
    for (std::size_t t = 0; t < frames_.count(); ++t) {
      const VertexPlaces places = frames_.places(t);
      const Point& to = edge.to[t];
      const bool flat = edge.flat[t] != 0;
      const double near = WitnessPoints::near_square(to, edge.costs[t], rounding_.relative);
      const Point& of_kept = flat ? places[kept] : witness(kept, t);
      const Point& of_removed = flat ? places[removed] : witness(removed, t);
      const double kept_square =
          hub ? 0
              : square_beside_star(of_kept, to, star.of_kept(), star.of_removed(), places, near);
      const double removed_square =
          square_beside_star(of_removed, to, star.of_removed(), star.of_kept(), places, near);
      const bool first = hub || (flat ? to == places[kept] : kept_square >= removed_square);
      witness_of_kept_[t] = witness(first ? kept : removed, t);
      const double square = std::max(kept_square, removed_square);
      if (square <= near) continue;
      edge.costs[t] = std::max(edge.costs[t], WitnessPoints::cost_of(square));
      costlier = true;
    }
    return costlier;
  }

  void collapsing(const Collapse& collapse, EdgeStar& star, const EdgeInFrames& edge,
                  const BesideCollapse& beside) override {
    const VertexNumber kept = collapse.kept;
    at_boundary_now_ = (at_boundary_[kept] | at_boundary_[collapse.removed]) != 0;
    if (at_boundary_now_) {
      beside.for_each_open_before(
          collapse, star, [&](VertexNumber end, VertexNumber w) { add_boundary(end, w, -1); });
    }
    const auto faces = star.faces();
    for (std::size_t t = 0; t < frames_.count(); ++t) {
      star.move(frames_.places(t), edge.to[t], least_cosine_);
      VertexPlanes& of_kept = planes_of_kept_[t];
      of_kept = beside.into_hub() ? planes(kept, t) : VertexPlanes{};
      for (std::size_t i = 0; i < faces.size(); ++i) {
        const VertexPlanes change = star.change(i);
        add(planes(faces[i].w, t), change);
        add(planes(faces[i].x, t), change);
        // A hub's own faces stay as they are, but for those at the edge.
        add(of_kept, beside.into_hub() && !faces[i].stays ? change : star.planes(i));
      }
    }
    std::copy(witness_of_kept_.begin(), witness_of_kept_.end(), &witness(kept, 0));
  }

  void collapsed(const Collapse& collapse, const BesideCollapse& beside) override {
    const VertexNumber kept = collapse.kept;
    std::copy(planes_of_kept_.begin(), planes_of_kept_.end(), &planes(kept, 0));
    at_boundary_[kept] |= at_boundary_[collapse.removed];
    if (!at_boundary_now_) return;
    beside.for_each_open_after(collapse,
                               [&](VertexNumber end, VertexNumber w) { add_boundary(end, w, 1); });
  }

  void save(VertexNumber v, std::byte* into) const override {
    std::memcpy(into, &witness_[at(v, 0)], frames_.count() * sizeof(Point));
  }

 private:
  [[nodiscard]] std::size_t at(VertexNumber v, std::size_t frame) const {
    return v * frames_.count() + frame;
  }
  [[nodiscard]] VertexPlanes& planes(VertexNumber v, std::size_t frame) {
    return planes_[at(v, frame)];
  }
  [[nodiscard]] Point& witness(VertexNumber v, std::size_t frame) { return witness_[at(v, frame)]; }

  void add_boundary(VertexNumber a, VertexNumber b, double sign) {
    if (!at_boundary_[a] || !at_boundary_[b]) return;
    for (std::size_t t = 0; t < frames_.count(); ++t) {
      const Point edge = frames_.positions(b)[t] - frames_.positions(a)[t];
      add_line(planes(a, t), edge, sign * boundary_line_weight);
      add_line(planes(b, t), edge, sign * boundary_line_weight);
    }
  }

  TileMesh& mesh_;
  const Frames& frames_;
  bool single_;
  CoordinateRounding rounding_;
  double least_cosine_;
  std::vector<VertexPlanes> planes_;  // those of a vertex side by side
  std::vector<Point> witness_;
  std::vector<std::uint8_t> at_boundary_;  // may be; a vertex that is not is at none
  EdgeKernel evaluate_edges_;
  EdgeBatch batch_{};
  // Of the collapse that is being made: afterwards.
  std::vector<Point> witness_of_kept_;
  std::vector<VertexPlanes> planes_of_kept_;
  bool at_boundary_now_ = false;
};

}  // namespace

std::unique_ptr<FrameQuadrics> make_memoryless_quadrics(TileMesh& mesh, const Frames& frames,
                                                        std::span<const std::byte> state,
                                                        const DecimationSettings& settings) {
  return std::make_unique<MemorylessFrames>(mesh, frames, state, settings);
}

}  // namespace winnow
