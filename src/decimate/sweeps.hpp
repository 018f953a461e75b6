// Collapsing edges without a queue: most collapses come early, and their exact order hardly
// matters. In a sweep all edges get their costs at once, and of the cheapest those are collapsed
// that are at no vertex of one before. By the quadrics of quadric_cost.hpp, summed up anew before
// each sweep.
#pragma once

#include "decimate/collapser.hpp"
#include "decimate/corner_lists.hpp"
#include "decimate/edge_batch.hpp"
#include "decimate/edge_star.hpp"
#include "decimate/legality.hpp"
#include "decimate/proposals.hpp"
#include "decimate/tile_mesh.hpp"
#include "decimate/witness_points.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace winnow {

// `highest_cost`: of what was collapsed.
struct Swept {
  WitnessPoints witnesses;
  double largest_square = 0;  // of the distance of a vertex from its planes, in the mean
  double highest_cost = 0;
};

class Sweeps {
 public:
  // `single`: vertices go to numbers that floats have. The mesh needs no links.
  Sweeps(TileMesh& mesh, bool single, const CollapseRules& rules);

  // Bytes in use at the most, besides the mesh without its links.
  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    // Two faces a vertex.
    return WitnessPoints::memory(vertices) + Proposals::memory(vertices) +
           CornerLists::memory(vertices, 2 * vertices) +
           vertices * (sizeof(VertexPlanes) + 2 + 2 * sizeof(VertexNumber)) +
           2 * vertices * sizeof(SurvivingFace);
  }

  // Down to CollapseLimits::sweeps_to, or as far as sweeps are worth it. True where nothing is left
  // to do.
  bool run(const CollapseLimits& limits, const std::function<void(const DoneCollapse&)>& done,
           const std::function<void()>& turn);

  [[nodiscard]] double largest_square() const { return largest_square_; }
  // What it leaves for what is collapsed afterwards.
  [[nodiscard]] Swept hand_on() && { return {std::move(witnesses_), largest_square_, highest_}; }

 private:
  enum State : std::uint8_t { untouched, kept_in_place, moved, gone };  // in a sweep

  void begin();
  void sum_planes();
  void evaluate_edges();
  void add_edge(VertexNumber low, VertexNumber high);
  void evaluate_batch();
  void find_single_neighbours(VertexNumber v);
  [[nodiscard]] bool is_open(VertexNumber end);
  [[nodiscard]] bool keeps_surface();
  [[nodiscard]] bool keeps_surface_at_hub();
  void gather_star(VertexNumber low, VertexNumber high);
  void gather_star_at_hub(VertexNumber low, VertexNumber hub);
  [[nodiscard]] bool has_moved_beside() const;
  [[nodiscard]] bool take(VertexNumber low, double bound);
  unsigned collapse(const Collapse& edge, double cost);
  void rewrite_faces();

  TileMesh& mesh_;
  bool single_;
  CollapseRules rules_;
  EdgeKernel evaluate_edges_;
  PlaneKernel take_planes_;
  Legality legality_;
  EdgeStar star_;
  WitnessPoints witnesses_;
  Proposals proposals_{0};
  CornerLists corners_{0};
  std::vector<SurvivingFace> faces_;    // that are left
  std::vector<VertexNumber> vertices_;  // that may be collapsed
  std::vector<VertexPlanes> planes_;
  std::vector<VertexNumber> into_;  // what each vertex was collapsed into in this sweep
  std::vector<std::uint8_t> state_;
  std::vector<std::uint8_t> at_boundary_;  // may be; a vertex that is not is at none
  EdgeBatch batch_{};
  StarBatch face_batch_{};
  std::array<VertexNumber, EdgeBatch::capacity> lows_{}, highs_{};
  std::size_t in_batch_ = 0;
  std::vector<VertexNumber> met_;
  bool coarse_ = false;  // the sweep
  Collapse edge_;        // that take() took
  double cost_ = 0;      // of it
  double highest_ = 0;
  double largest_square_ = 0;
};

}  // namespace winnow
