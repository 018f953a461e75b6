// The face of a surface that is nearest to a point.
#pragma once

#include "base/vector.hpp"
#include "io/job.hpp"
#include "read/good_faces.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

namespace winnow {

struct NearestFace {
  double squared = std::numeric_limits<double>::infinity();  // of the distance
  std::uint64_t number = std::numeric_limits<std::uint64_t>::max();
  const NumberedFace* face = nullptr;  // while its tree lives

  // The lower number of equally near faces, so that no order of searching shows.
  [[nodiscard]] bool farther_than(double other_squared, std::uint64_t other_number) const {
    return other_squared < squared || (other_squared == squared && other_number < number);
  }
};

// `face` as if it were the nearest.
NearestFace distance_to(const NumberedFace& face, const Point& point);

// Embree's hierarchy of boxes, in single precision and a little larger than the faces, decides
// which faces are looked at; their distances are exact to double rounding.
class SurfaceTree {
 public:
  // Memory of a tree, beside the faces themselves, which stay the caller's.
  static constexpr std::uint64_t bytes_a_face = 192;
  static constexpr std::uint64_t most_faces = std::uint64_t{1} << 30;  // Embree counts with 32 bits

  SurfaceTree(Job& job, std::span<const NumberedFace> faces);
  ~SurfaceTree();
  SurfaceTree(const SurfaceTree&) = delete;
  SurfaceTree& operator=(const SurfaceTree&) = delete;

  // Makes `best` the nearest face if one of this tree is nearer; true if so. Stops early once the
  // nearest is nearer than `enough`. From any thread.
  bool search(const Point& point, NearestFace& best, double enough_squared = 0) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Searches for points that mostly lie near each other: one that begins with the face that the last
// found is short. By one thread.
class NeighbourSearch {
 public:
  explicit NeighbourSearch(const SurfaceTree& tree) : tree_(tree) {}

  // As SurfaceTree::search().
  bool search(const Point& point, NearestFace& best, double enough_squared = 0);

 private:
  const SurfaceTree& tree_;
  const NumberedFace* last_ = nullptr;
};

}  // namespace winnow
