// How far the vertex of a collapsed edge is from the planes of the faces that meet its two ends,
// each weighted by its area: the quadrics of Garland and Heckbert (1997), of the faces as they are
// now. That quadrics forget what was collapsed before (Lindstrom and Turk 1998) takes a quarter off
// the error at the same count (bench/RESULTS.md). What is forgotten that way and must not be:
// witness_points.hpp.
#pragma once

#include "decimate/beside_collapse.hpp"
#include "decimate/collapser.hpp"
#include "decimate/edge_batch.hpp"
#include "decimate/error_bound.hpp"
#include "decimate/legality.hpp"
#include "decimate/witness_points.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace winnow {

class QuadricCost {
 public:
  // What a vertex remembers between two rounds, within an error.
  struct State : ErrorBound::State {
    Point farthest{};  // the point of WitnessPoints, seen from it
  };

  // `single`: vertices go to numbers that floats have.
  QuadricCost(TileMesh& mesh, bool single, const CoordinateRounding& rounding);
  // Goes on from what was collapsed before.
  QuadricCost(TileMesh& mesh, bool single, const CoordinateRounding& rounding,
              WitnessPoints witnesses, double largest_square);
  // The same within an error; `states`: of each vertex.
  QuadricCost(TileMesh& mesh, bool single, const CoordinateRounding& rounding, double error,
              std::vector<ErrorBound::State> states);
  QuadricCost(TileMesh& mesh, bool single, const CoordinateRounding& rounding, double error,
              const std::vector<State>& states);

  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    return vertices * (sizeof(VertexPlanes) + 1) + WitnessPoints::memory(vertices);
  }

  [[nodiscard]] Candidate best(VertexNumber v, const Candidate& after);
  [[nodiscard]] EvaluatedCollapse place(VertexNumber low, VertexNumber high);
  // The same at the other end, where nothing is lost there either. Asked only of what place() gave
  // last.
  [[nodiscard]] std::optional<EvaluatedCollapse> other_place(const EvaluatedCollapse& now) const;
  // `change`: null where the surface stays what it is.
  [[nodiscard]] double closer_cost(const EvaluatedCollapse& now, const EdgeStar& star, double cost,
                                   const SurfaceChange* change = nullptr);
  // As if all points of the piece went to its middle. Planes do not know how far a flat piece
  // reaches.
  [[nodiscard]] double cost_of_piece(const TileMesh& mesh, const Piece& piece) const;
  [[nodiscard]] static double cost_of(const PieceLoss& loss);
  [[nodiscard]] double cost_of_change(const EdgeStar& star, const Collapse& edge,
                                      const SurfaceChange& change);
  [[nodiscard]] double cost_of_turning(const EdgeStar& star, const Collapse& edge) const;
  void faces_gone(std::span<const FaceVertices> faces, Offers& offers);
  void faces_gone(std::span<const FaceVertices> faces);
  void collapsing(const EvaluatedCollapse& now, const EdgeStar& star);
  void collapsed(const Collapse& edge, Offers& offers);
  void collapsed(const Collapse& edge);
  // A collapse of an earlier run, whose star this is: what collapsing() and collapsed() do but for
  // offers.
  void repeat(const Collapse& edge, EdgeStar& star, const SurfaceChange* change);

  // Within an error.
  [[nodiscard]] State state(VertexNumber v) const;

  // The root of the mean squared distance of a vertex from the planes it was collapsed at, the
  // largest there was; within an error, from all planes that it stands for.
  [[nodiscard]] double largest_error() const;

 private:
  [[nodiscard]] VertexPlanes planes_of(FaceNumber f) const;
  void take_anew(VertexNumber v);
  void add_boundary(VertexNumber a, VertexNumber b, double sign);

  TileMesh& mesh_;
  bool single_;
  CoordinateRounding rounding_;
  std::vector<VertexPlanes> planes_;
  WitnessPoints farthest_;
  std::vector<std::uint8_t> at_boundary_;  // may be; a vertex that is not is at none
  std::optional<ErrorBound> bound_;
  EdgeKernel evaluate_edges_;
  EdgeBatch batch_{};
  double largest_square_ = 0;
  // Of the collapse that is being made.
  VertexPlanes planes_of_kept_;  // afterwards
  BesideCollapse beside_;
  bool at_boundary_now_ = false;
};

}  // namespace winnow
