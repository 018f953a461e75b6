#include "decimate/edge_star.hpp"

#include "base/instruction_set.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace winnow {

EdgeStar::EdgeStar(const CoordinateRounding& rounding)
    : rounding_(rounding),
      turn_(best_kernel(WINNOW_KERNELS(star_kernel))),
      measure_(best_kernel(WINNOW_KERNELS(distance_kernel))) {}

void EdgeStar::find(const TileMesh& mesh, VertexNumber kept, VertexNumber removed) {
  kept_ = kept;
  removed_ = removed;
  faces_.clear();
  if (mesh.hub(kept)) {
    mesh.for_each_corner(removed, [&](FaceNumber f, VertexNumber w, VertexNumber x) {
      if (w == kept) faces_.push_back({f, x, removed, false});
      if (x == kept) faces_.push_back({f, removed, w, false});
    });
  } else {
    mesh.for_each_corner(kept, [&](FaceNumber f, VertexNumber w, VertexNumber x) {
      faces_.push_back({f, w, x, w != removed && x != removed});
    });
  }
  buffered_faces_ = faces_.size();
  mesh.for_each_corner(removed, [&](FaceNumber f, VertexNumber w, VertexNumber x) {
    if (w != kept && x != kept) faces_.push_back({f, w, x, true});
  });
}

void EdgeStar::move(const VertexPlaces& places, const Point& to, double least_cosine) {
  constexpr std::size_t capacity = StarBatch::capacity;
  const std::size_t needed = (faces_.size() + capacity - 1) / capacity;
  if (batches_.size() < needed) batches_.resize(needed);
  const Point of_kept = places[kept_];
  const Point of_removed = places[removed_];
  for (std::size_t first = 0; first < faces_.size(); first += capacity) {
    StarBatch& batch = batches_[first / capacity];
    std::copy(to.begin(), to.end(), batch.to);
    const std::size_t count = std::min(capacity, faces_.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const StarFace& face = faces_[first + i];
      const Point& from = first + i < buffered_faces_ ? of_kept : of_removed;
      set_corners(batch, i, from, places[face.w], places[face.x]);
      batch.stays[i] = face.stays ? 1 : 0;
    }
    turn_(batch, count, {least_cosine, rounding_.relative, rounding_.absolute, planes_});
  }
}

std::array<double, 2> EdgeStar::squares_from(const Point& a, const Point& b) const {
  constexpr std::size_t capacity = StarBatch::capacity;
  constexpr double none = std::numeric_limits<double>::infinity();
  const double at[2][3] = {{a[0], a[1], a[2]}, {b[0], b[1], b[2]}};
  double least[2][star_kernel_lanes];
  std::fill(&least[0][0], &least[0][0] + 2 * star_kernel_lanes, none);
  for (std::size_t first = 0; first < faces_.size(); first += capacity)
    measure_(batches_[first / capacity], std::min(capacity, faces_.size() - first), at, least);
  return {*std::min_element(least[0], least[0] + star_kernel_lanes),
          *std::min_element(least[1], least[1] + star_kernel_lanes)};
}

}  // namespace winnow
