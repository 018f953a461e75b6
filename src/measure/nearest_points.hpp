// Points of a mesh, and how near the nearest face of another surface is that comes in parts.
#pragma once

#include <winnow/compare.hpp>

#include "io/job.hpp"
#include "measure/distance_sums.hpp"
#include "measure/surface_sampler.hpp"
#include "measure/surface_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

// The points: evenly spread samples, all vertices, and four inner points of each face, which tell
// whether the face shows its back. Where they are is computed anew when needed; only distances are
// kept.
class NearestPoints {
 public:
  static constexpr std::uint64_t bytes_a_face = 4 * 16 + 16;

  // `faces` and `vertices` must stay.
  NearestPoints(Job& job, std::span<const NumberedFace> faces, const std::vector<Point>& vertices,
                const SurfaceSampler& sampler);

  // Takes some more faces of the other surface into account, in any order.
  void approach(std::span<const NumberedFace> surface);

  // When all have been seen: distances, and the count of flipped faces.
  void finish(CompareReport& report, DistanceSums& sums) const;
  [[nodiscard]] const std::vector<double>& vertex_distances() const { return vertex_squared_; }

 private:
  struct InnerPoint {
    double squared;
    std::uint64_t number : 63;
    std::uint64_t opposed : 1;
  };
  static constexpr std::uint64_t no_number = (std::uint64_t{1} << 63) - 1;
  void approach_block(const SurfaceTree& tree, std::size_t block);

  Job& job_;
  Reservation reservation_;
  std::span<const NumberedFace> faces_;
  const std::vector<Point>& vertices_;
  SurfaceSampler sampler_;
  std::vector<std::uint64_t> first_sample_;  // of each block of faces
  std::vector<double> sample_squared_, vertex_squared_;
  std::vector<InnerPoint> inner_;
};

}  // namespace winnow
