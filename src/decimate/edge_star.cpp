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

double EdgeStar::square_from(const Point& point) const {
  constexpr std::size_t capacity = StarBatch::capacity;
  const double at[3] = {point[0], point[1], point[2]};
  double squares[capacity];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first < faces_.size(); first += capacity) {
    const std::size_t count = std::min(capacity, faces_.size() - first);
    measure_(batches_[first / capacity], count, at, squares);
    for (std::size_t i = 0; i < count; ++i) least = std::min(least, squares[i]);
  }
  return least;
}

}  // namespace winnow
