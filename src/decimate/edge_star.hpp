// The faces around an edge that is to be collapsed.
#pragma once

#include "base/rounding.hpp"
#include "decimate/edge_batch.hpp"
#include "decimate/kernel/star_kernel.hpp"
#include "decimate/tile_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

inline void set_corners(StarBatch& batch, std::size_t i, const Point& from, const Point& second,
                        const Point& third) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    batch.from[axis][i] = from[axis];
    batch.second[axis][i] = second[axis];
    batch.third[axis][i] = third[axis];
  }
}

inline VertexPlanes planes_of(const double (&sums)[6][StarBatch::capacity], std::size_t i) {
  return {sums[0][i], sums[1][i], sums[2][i], sums[3][i], sums[4][i], sums[5][i]};
}

// Around a hub only the faces that the collapse changes: the hub stays where it is.
class EdgeStar {
 public:
  // `rounding`: of positions (base/rounding.hpp).
  explicit EdgeStar(const CoordinateRounding& rounding);

  void find(const TileMesh& mesh, VertexNumber kept, VertexNumber removed);

  // The same face by face: all of one end, then those of the other.
  void begin(VertexNumber kept, VertexNumber removed) {
    kept_ = kept;
    removed_ = removed;
    faces_.clear();
    buffered_faces_ = 0;
  }
  void add_of_kept(const StarFace& face) {
    faces_.push_back(face);
    ++buffered_faces_;
  }
  void add_of_removed(const StarFace& face) { faces_.push_back(face); }

  [[nodiscard]] VertexNumber kept() const { return kept_; }
  [[nodiscard]] VertexNumber removed() const { return removed_; }

  // The faces of one end, of a hub those at the edge, and those of the other without the ones at
  // the edge, which are told once.
  [[nodiscard]] std::span<const StarFace> of_kept() const {
    return std::span(faces_).first(buffered_faces_);
  }
  [[nodiscard]] std::span<const StarFace> of_removed() const {
    return std::span(faces_).subspan(buffered_faces_);
  }
  [[nodiscard]] std::span<const StarFace> faces() const { return faces_; }

  // Whether planes() and change() will be asked for.
  void want_planes(bool want) { planes_ = want; }

  // What comes of them, in this order, when the ends move there.
  void move(const VertexPlaces& places, const Point& to, double least_cosine);
  void move(const TileMesh& mesh, const Point& to, double least_cosine) {
    move(mesh.places(), to, least_cosine);
  }
  [[nodiscard]] bool turned(std::size_t face) const { return batch(face).turned[lane(face)] != 0; }
  // Whether a face that was thinner than rounding no longer is.
  [[nodiscard]] bool opened(std::size_t face) const { return batch(face).opened[lane(face)] != 0; }
  [[nodiscard]] VertexPlanes planes(std::size_t face) const {
    return planes_of(batch(face).planes, lane(face));
  }
  [[nodiscard]] VertexPlanes change(std::size_t face) const {
    return planes_of(batch(face).change, lane(face));
  }

  // The squares of the distances of two points, each from the nearest of them that it lies above or
  // below; infinite where there is none.
  [[nodiscard]] std::array<double, 2> squares_from(const Point& a, const Point& b) const;

 private:
  static std::size_t lane(std::size_t face) { return face % StarBatch::capacity; }
  [[nodiscard]] const StarBatch& batch(std::size_t face) const {
    return batches_[face / StarBatch::capacity];
  }

  VertexNumber kept_ = no_number, removed_ = no_number;
  std::vector<StarFace> faces_;
  std::size_t buffered_faces_ = 0;
  CoordinateRounding rounding_;
  StarKernel turn_;
  DistanceKernel measure_;
  bool planes_ = true;
  std::vector<StarBatch> batches_;
};

}  // namespace winnow
