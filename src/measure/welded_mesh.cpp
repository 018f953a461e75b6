#include "measure/welded_mesh.hpp"

#include <winnow/error.hpp>

#include "base/edge_hash.hpp"
#include "base/exact_sum.hpp"
#include "base/text.hpp"
#include "measure/edge_count.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

namespace winnow {

namespace {

// Open addressing from places to their numbers.
class PlaceTable {
 public:
  explicit PlaceTable(std::size_t places)
      : slots_(std::bit_ceil(places + places / 2 + 16), empty), mask_(slots_.size() - 1) {}

  // The number of the vertex at `place`, which becomes a new one if there is none.
  std::uint32_t number(const Point& place, std::vector<Point>& vertices) {
    std::size_t at = position_hash(place) & mask_;
    while (slots_[at] != empty && vertices[slots_[at]] != place) at = (at + 1) & mask_;
    if (slots_[at] == empty) {
      slots_[at] = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(place);
    }
    return slots_[at];
  }

 private:
  static constexpr std::uint32_t empty = UINT32_MAX;
  std::vector<std::uint32_t> slots_;
  std::size_t mask_;
};

}  // namespace

WeldedMesh::WeldedMesh(Job& job, std::span<const NumberedFace> faces) : job_(job) {
  if (faces.size() > UINT32_MAX / 3) {
    throw Error(ErrorKind::resources,
                "a simplified mesh of " + grouped(faces.size()) +
                    " faces is too large to compare; give the smaller mesh second");
  }
  constexpr const char* what = "the simplified mesh";
  reservation_ = job.budget.reserve(faces.size() * bytes_a_sealed_face, what);
  making_ = job.budget.reserve(faces.size() * (bytes_a_face - bytes_a_sealed_face), what);
  faces_.reserve(faces.size());
  // A closed surface has half as many vertices as faces; one of loose faces three times as many.
  std::size_t room = faces.size() + 3;
  PlaceTable table(room);
  vertices_.reserve(room);
  for (const NumberedFace& face : faces) {
    if (vertices_.size() + 3 > room) {
      // Of old and new, until the old ones are copied.
      room = 3 * faces.size() + 3;
      more_ = job.budget.reserve(room * bytes_a_place, "the vertices of the simplified mesh");
      table = PlaceTable(room);
      std::vector<Point> places;
      places.reserve(room);
      for (const Point& place : vertices_) table.number(place, places);
      vertices_.swap(places);
    }
    faces_.push_back({table.number(face.corner[0], vertices_),
                      table.number(face.corner[1], vertices_),
                      table.number(face.corner[2], vertices_)});
    if (faces_.size() % 65536 == 0) job.progress.check_cancelled();
  }
}

bool WeldedMesh::has_area(const std::array<std::uint32_t, 3>& face) const {
  const Point area = doubled_area({vertices_[face[0]], vertices_[face[1]], vertices_[face[2]]});
  return area != Point{};
}

CompareReport::Topology WeldedMesh::topology() const {
  CompareReport::Topology topology;
  for (const auto& face : faces_) topology.degenerate += has_area(face) ? 0 : 1;
  count_edges(topology);
  count_duplicates(topology);
  count_components(topology);
  return topology;
}

void WeldedMesh::count_edges(CompareReport::Topology& topology) const {
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * faces_.size());
  for (const auto& face : faces_) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint64_t a = face[corner];
      const std::uint64_t b = face[(corner + 1) % 3];
      edges.push_back(std::min(a, b) << 32 | std::max(a, b));
    }
  }
  std::sort(edges.begin(), edges.end(), job_.progress.cancellable(std::less<>()));
  EdgeRuns runs;
  for (const std::uint64_t edge : edges) {
    job_.progress.check_cancelled();
    runs.add(edge);
  }
  const SurfaceEdges counts = runs.finish();
  topology.boundary_edges = counts.boundary;
  topology.non_manifold_edges = counts.non_manifold;
}

void WeldedMesh::count_duplicates(CompareReport::Topology& topology) const {
  std::vector<std::array<std::uint32_t, 3>> sorted = faces_;
  for (auto& face : sorted) std::sort(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end(), job_.progress.cancellable(std::less<>()));
  for (std::size_t i = 1; i < sorted.size(); ++i)
    topology.duplicate += sorted[i] == sorted[i - 1] ? 1 : 0;
}

void WeldedMesh::count_components(CompareReport::Topology& topology) const {
  std::vector<std::uint32_t> parent(vertices_.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&parent](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::uint64_t components = vertices_.size();
  for (const auto& face : faces_) {
    job_.progress.check_cancelled();
    for (const std::uint32_t other : {face[1], face[2]}) {
      const std::uint32_t a = root(face[0]);
      const std::uint32_t b = root(other);
      if (a == b) continue;
      parent[std::max(a, b)] = std::min(a, b);
      --components;
    }
  }
  topology.components = components;
}

CompareReport::Angles WeldedMesh::smallest_angles() const {
  constexpr double degrees = 180 / std::numbers::pi;
  CompareReport::Angles angles;
  angles.min = 180;
  ExactSum sum;
  std::uint64_t count = 0;
  std::uint64_t small = 0;
  for (const auto& face : faces_) {
    job_.progress.check_cancelled();
    if (!has_area(face)) continue;
    double smallest = 180;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Point& at = vertices_[face[corner]];
      const Point one = vertices_[face[(corner + 1) % 3]] - at;
      const Point other = vertices_[face[(corner + 2) % 3]] - at;
      smallest =
          std::min(smallest, std::atan2(length(cross(one, other)), dot(one, other)) * degrees);
    }
    angles.min = std::min(angles.min, smallest);
    sum.add(smallest);
    small += smallest < 10 ? 1 : 0;
    ++count;
  }
  if (count == 0) return {};
  angles.mean = sum.value() / static_cast<double>(count);
  angles.below_10 = static_cast<double>(small) / static_cast<double>(count);
  return angles;
}

}  // namespace winnow
