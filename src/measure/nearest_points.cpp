#include "measure/nearest_points.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <limits>

namespace winnow {

namespace {

constexpr std::size_t block_faces = 1024;
constexpr double not_met = std::numeric_limits<double>::infinity();

std::size_t blocks_of(std::size_t count) {
  return (count + block_faces - 1) / block_faces;
}

Point inner_point(const Triangle& t, std::size_t which) {
  constexpr double third = 1.0 / 3;
  constexpr std::array<std::array<double, 3>, 4> weights{
      {{third, third, third}, {0.6, 0.2, 0.2}, {0.2, 0.6, 0.2}, {0.2, 0.2, 0.6}}};
  const auto& [a, b, c] = weights[which];
  return a * t[0] + (b * t[1] + c * t[2]);
}

}  // namespace

NearestPoints::NearestPoints(Job& job, std::span<const NumberedFace> faces,
                             const std::vector<Point>& vertices, const SurfaceSampler& sampler)
    : job_(job), faces_(faces), vertices_(vertices), sampler_(sampler) {
  std::uint64_t samples = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i % block_faces == 0) {
      job.progress.check_cancelled();
      first_sample_.push_back(samples);
    }
    samples += sampler_.count(faces[i].number, length(doubled_area(faces[i].corner)) / 2);
  }
  reservation_ = job.budget.reserve(samples * sizeof(double) + vertices.size() * sizeof(double) +
                                        4 * faces.size() * sizeof(InnerPoint),
                                    "distances of the simplified mesh");
  sample_squared_.assign(samples, not_met);
  vertex_squared_.assign(vertices.size(), not_met);
  inner_.assign(4 * faces.size(), {not_met, no_number, 0});
}

void NearestPoints::approach(std::span<const NumberedFace> surface) {
  if (surface.empty()) return;
  const SurfaceTree tree(job_, surface);
  parallel_for(blocks_of(faces_.size()), [&](std::size_t block) {
    job_.progress.check_cancelled();
    approach_block(tree, block);
  });
  parallel_for(blocks_of(vertices_.size()), [&](std::size_t block) {
    job_.progress.check_cancelled();
    const std::size_t end = std::min(vertices_.size(), (block + 1) * block_faces);
    for (std::size_t v = block * block_faces; v < end; ++v) {
      NearestFace nearest{vertex_squared_[v], 0};
      if (tree.search(vertices_[v], nearest)) vertex_squared_[v] = nearest.squared;
    }
  });
}

void NearestPoints::approach_block(const SurfaceTree& tree, std::size_t block) {
  std::uint64_t at = first_sample_[block];
  const std::size_t end = std::min(faces_.size(), (block + 1) * block_faces);
  NeighbourSearch neighbours(tree);
  for (std::size_t f = block * block_faces; f < end; ++f) {
    job_.progress.check_cancelled();
    const NumberedFace& face = faces_[f];
    const Point normal = doubled_area(face.corner);
    const std::uint64_t samples = sampler_.count(face.number, length(normal) / 2);
    for (std::uint64_t k = 0; k < samples; ++k, ++at) {
      if (k % 256 == 255) job_.progress.check_cancelled();
      // Number 0 lets no other face of the same distance win: only the distance counts.
      NearestFace nearest{sample_squared_[at], 0};
      if (neighbours.search(SurfaceSampler::point(face.number, k, face.corner), nearest))
        sample_squared_[at] = nearest.squared;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      InnerPoint& inner = inner_[4 * f + k];
      NearestFace nearest{inner.squared, inner.number};
      if (neighbours.search(inner_point(face.corner, k), nearest))
        inner = {nearest.squared, nearest.number & no_number,
                 dot(normal, doubled_area(nearest.face->corner)) < 0 ? 1U : 0U};
    }
  }
}

void NearestPoints::finish(CompareReport& report, DistanceSums& sums) const {
  for (std::size_t block = 0; block < first_sample_.size(); ++block) {
    job_.progress.check_cancelled();
    std::uint64_t at = first_sample_[block];
    const std::size_t end = std::min(faces_.size(), (block + 1) * block_faces);
    for (std::size_t f = block * block_faces; f < end; ++f) {
      const NumberedFace& face = faces_[f];
      const std::uint64_t samples =
          sampler_.count(face.number, length(doubled_area(face.corner)) / 2);
      for (std::uint64_t k = 0; k < samples; ++k, ++at)
        sums.add(sample_squared_[at], SurfaceSampler::point(face.number, k, face.corner));
      report.topology.flipped +=
          std::all_of(inner_.begin() + static_cast<std::ptrdiff_t>(4 * f),
                      inner_.begin() + static_cast<std::ptrdiff_t>(4 * f + 4),
                      [](const InnerPoint& inner) { return inner.opposed != 0; })
              ? 1
              : 0;
    }
  }
  for (std::size_t v = 0; v < vertices_.size(); ++v)
    sums.add_to_maximum(vertex_squared_[v], vertices_[v]);
  report.backward = sums.distances();
  report.simplified.samples = sums.samples();
}

}  // namespace winnow
