// What it costs to collapse an edge in all frames of a sequence (Zhang and Wu):
//
//   (1 + k2 * feature weight) * sum of costs + k1 * sum of |cost - mean cost|
//
// The cost of a frame is that of frame_quadrics.hpp, with a best position of its own in each frame:
// by memoryless quadrics and witness points, or by quadrics that remember, as Zhang and Wu have it.
// A collapse is legal if it is in every frame. Where the best position turns a face of
// one frame too far, that frame takes the next best of both ends and the middle. Where all of them
// do, the collapse costs more: of many frames there is nearly always one that would forbid it.
#pragma once

#include "decimate/beside_collapse.hpp"
#include "decimate/collapser.hpp"
#include "decimate/decimation.hpp"
#include "decimate/frame_quadrics.hpp"
#include "decimate/frames.hpp"
#include "decimate/legality.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

class SequenceCost {
 public:
  // `frames` must stay.
  SequenceCost(TileMesh& mesh, Frames& frames, std::span<const std::byte> state,
               const DecimationSettings& settings);

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

  // Writes remembered_size() bytes.
  void save(VertexNumber v, std::byte* into) const { quadrics_->save(v, into); }

  // The root of the mean squared distance of a vertex from the planes it was collapsed at, the
  // largest there was in any frame.
  [[nodiscard]] double largest_error() const;

 private:
  [[nodiscard]] double sum_of_costs(double feature) const;
  [[nodiscard]] double feature_weight(VertexNumber low, VertexNumber high);
  [[nodiscard]] bool place_otherwise(std::size_t frame, const Legality& legality, EdgeStar& star,
                                     const Collapse& edge);
  void collapsed(const Collapse& edge);

  TileMesh& mesh_;
  Frames& frames_;
  SequenceSettings settings_;
  bool single_;
  double least_cosine_;
  std::unique_ptr<FrameQuadrics> quadrics_;
  std::vector<VertexNumber> ends_;
  double largest_square_ = 0;
  EdgeInFrames edge_;   // that was evaluated last
  double feature_ = 0;  // of it
  BesideCollapse beside_;
};

}  // namespace winnow
