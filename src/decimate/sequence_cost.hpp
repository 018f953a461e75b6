// What it costs to collapse an edge in all frames of a sequence (Zhang and Wu):
//
//   (1 + k2 * feature weight) * sum of costs + k1 * sum of |cost - mean cost|
//
// The cost of a frame is that of quadric_cost.hpp: memoryless quadrics, with a best position of its
// own in each frame, and the witness points of that frame. Zhang and Wu take quadrics that
// remember. A collapse is legal if it is in every frame. Where the best position turns a face of
// one frame too far, that frame takes the next best of both ends and the middle. Where all of them
// do, the collapse costs more: of many frames there is nearly always one that would forbid it.
#pragma once

#include "decimate/beside_collapse.hpp"
#include "decimate/collapser.hpp"
#include "decimate/decimation.hpp"
#include "decimate/edge_batch.hpp"
#include "decimate/frames.hpp"
#include "decimate/legality.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

class SequenceCost {
 public:
  // `frames` must stay.
  SequenceCost(TileMesh& mesh, Frames& frames, const DecimationSettings& settings);

  static constexpr std::uint64_t memory(std::size_t frames, std::uint64_t vertices) {
    return vertices * (frames * sizeof(VertexPlanes) + 1);
  }

  [[nodiscard]] Candidate best(VertexNumber v, const Candidate& after);
  [[nodiscard]] EvaluatedCollapse place(VertexNumber low, VertexNumber high);
  // Of what place() gave last, whose star this is.
  [[nodiscard]] bool keeps_faces(const Legality& legality, EdgeStar& star, EvaluatedCollapse& now);
  [[nodiscard]] double closer_cost(const EvaluatedCollapse& now, const EdgeStar& star, double cost);
  [[nodiscard]] double cost_of_piece(const TileMesh& mesh, const Piece& piece);
  void collapsing(const EvaluatedCollapse& now, EdgeStar& star);
  void collapsed(const Collapse& edge, Offers& offers);
  // A collapse of an earlier run, whose star this is.
  void repeat(const Collapse& edge, const Legality& legality, EdgeStar& star);

  // The root of the mean squared distance of a vertex from the planes it was collapsed at, the
  // largest there was in any frame.
  [[nodiscard]] double largest_error() const;

 private:
  void evaluate(VertexNumber low, VertexNumber high);
  [[nodiscard]] double sum_of_costs(VertexNumber low, VertexNumber high);
  [[nodiscard]] double sum_of_costs(double feature) const;
  [[nodiscard]] double feature_weight(VertexNumber low, VertexNumber high);
  [[nodiscard]] bool place_otherwise(std::size_t frame, const Legality& legality, EdgeStar& star,
                                     const Collapse& edge);
  [[nodiscard]] VertexPlanes& planes(VertexNumber v, std::size_t frame) {
    return planes_[v * frames_.count() + frame];
  }
  void add_boundary(VertexNumber a, VertexNumber b, double sign);
  void collapsed(const Collapse& edge);

  TileMesh& mesh_;
  Frames& frames_;
  SequenceSettings settings_;
  bool single_;
  CoordinateRounding rounding_;
  double least_cosine_;
  std::vector<VertexPlanes> planes_;       // those of a vertex side by side
  std::vector<std::uint8_t> at_boundary_;  // may be; a vertex that is not is at none
  EdgeKernel evaluate_edges_;
  EdgeBatch batch_{};
  std::vector<VertexNumber> ends_;
  double largest_square_ = 0;
  // Of the edge that was evaluated last, frame by frame.
  double feature_ = 0;
  std::vector<double> costs_;
  std::vector<Point> to_;
  std::vector<std::uint8_t> flat_;  // goes to an end where nothing is lost
  std::vector<Point> witness_;      // afterwards
  // Of the collapse that is being made.
  std::vector<VertexPlanes> planes_of_kept_;  // afterwards
  BesideCollapse beside_;
  bool at_boundary_now_ = false;
};

}  // namespace winnow
