// From points of the original to the simplified surface.
#pragma once

#include <winnow/compare.hpp>

#include "base/per_slot.hpp"
#include "io/job.hpp"
#include "measure/distance_sums.hpp"
#include "measure/normal_deviation.hpp"
#include "measure/surface_sampler.hpp"
#include "measure/surface_tree.hpp"

#include <span>
#include <vector>

namespace winnow {

// The points: samples, and all vertices. None is kept.
class ForwardDistances {
 public:
  // `tree` of the simplified surface and `sampler` must stay. Inside the job's arena.
  ForwardDistances(Job& job, const SurfaceTree& tree, const SurfaceSampler& sampler);

  // Of the original; in any order, from any thread.
  void add(std::span<const NumberedFace> faces);

  // When all have been added: distances, and how far the normals deviate.
  void finish(CompareReport& report, DistanceSums& sums) const;

 private:
  struct Part {
    explicit Part(const SurfaceTree& tree);
    NeighbourSearch neighbours;
    DistanceSums sums;
    NormalDeviation normals;
    std::vector<Point> recent;  // vertices that were just looked at: neighbouring faces share them
  };
  static void add_vertex(Part& part, const Point& point);

  Job& job_;
  const SurfaceSampler& sampler_;
  PerSlot<Part> parts_;
};

}  // namespace winnow
