#include "measure/forward_distances.hpp"

#include "base/edge_hash.hpp"
#include "base/hash.hpp"

#include <cmath>

namespace winnow {

namespace {

constexpr unsigned recent_bits = 12;

}  // namespace

ForwardDistances::Part::Part(const SurfaceTree& tree)
    : neighbours(tree), recent(std::size_t{1} << recent_bits, Point{NAN, NAN, NAN}) {}

ForwardDistances::ForwardDistances(Job& job, const SurfaceTree& tree, const SurfaceSampler& sampler)
    : job_(job),
      sampler_(sampler),
      parts_(job.threads, [&tree] { return std::make_unique<Part>(tree); }) {}

void ForwardDistances::add(std::span<const NumberedFace> faces) {
  Part& part = parts_.local();
  for (const NumberedFace& face : faces) {
    const Point normal = doubled_area(face.corner);
    const std::uint64_t samples = sampler_.count(face.number, length(normal) / 2);
    for (std::uint64_t k = 0; k < samples; ++k) {
      if (k % 256 == 255) job_.progress.check_cancelled();
      const Point point = SurfaceSampler::point(face.number, k, face.corner);
      NearestFace nearest;
      part.neighbours.search(point, nearest);
      part.sums.add(nearest.squared, point);
      part.normals.add(normal, doubled_area(nearest.face->corner));
    }
    for (const Point& corner : face.corner) add_vertex(part, corner);
  }
}

// Vertices count for the maximum alone, so one that is nearer than the farthest so far need not be
// exact.
void ForwardDistances::add_vertex(Part& part, const Point& point) {
  Point& recent = part.recent[quick_hash(position_hash(point)) >> (64 - recent_bits)];
  if (recent == point) return;
  recent = point;
  NearestFace nearest;
  part.neighbours.search(point, nearest, part.sums.largest_squared());
  part.sums.add_to_maximum(nearest.squared, point);
}

void ForwardDistances::finish(CompareReport& report, DistanceSums& sums) const {
  NormalDeviation normals;
  for (const Part* part : parts_.all()) {
    sums.merge(part->sums);
    normals.merge(part->normals);
  }
  report.forward = sums.distances();
  report.original.samples = sums.samples();
  report.normal_deviation = normals.result();
}

}  // namespace winnow
