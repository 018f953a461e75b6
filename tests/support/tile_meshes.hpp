// Tiles from triangles, and what is left of them.
#pragma once

#include "decimate/decimation.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

namespace winnow {

inline std::ostream& operator<<(std::ostream& out, Refine cost) {
  return out << facts_of(cost).name;
}

}  // namespace winnow

namespace winnow::test {

// All that edges can be collapsed by.
inline std::vector<Refine> costs() {
  std::vector<Refine> all;
  for (const Refine cost : all_values<Refine>()) {
    if (cost != Refine::none) all.push_back(cost);
  }
  return all;
}

// Different faces between few vertices.
inline std::vector<FaceVertices> random_mesh(Random& random, VertexNumber vertices,
                                             std::size_t tries) {
  std::set<FaceVertices> seen;
  std::vector<FaceVertices> faces;
  for (std::size_t i = 0; i < tries; ++i) {
    FaceVertices face{};
    // Often beside a face that is there: surfaces, with faults.
    if (!faces.empty() && random.chance(0.8)) face = random.one_of(faces);
    face[random.below(3)] = static_cast<VertexNumber>(random.below(vertices));
    if (faces.empty()) face = {0, 1, 2};
    FaceVertices sorted = face;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || !seen.insert(sorted).second) continue;
    faces.push_back(face);
  }
  return faces;
}

// Corners within a billionth of each other are one vertex.
inline TileMesh tile_of(const std::vector<Triangle>& triangles, double scale = 1) {
  std::map<std::array<long, 3>, VertexNumber> number;
  std::vector<Point> positions;
  std::vector<FaceVertices> faces;
  for (const Triangle& triangle : triangles) {
    FaceVertices& face = faces.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<long, 3> key{};
      for (std::size_t k = 0; k < 3; ++k) key[k] = std::lround(triangle[i][k] * 1e9);
      const auto [at, added] = number.emplace(key, static_cast<VertexNumber>(positions.size()));
      if (added) positions.push_back(scale * triangle[i]);
      face[i] = at->second;
    }
  }
  const std::size_t vertices = positions.size();
  return {std::move(positions), std::move(faces), std::vector<std::uint8_t>(vertices, 0)};
}

inline std::vector<Triangle> live_triangles(const TileMesh& mesh) {
  std::vector<Triangle> triangles;
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (!mesh.removed(f)) triangles.push_back(mesh.triangle(f));
  }
  return triangles;
}

// How many edges have one, two, three ... faces.
inline std::map<unsigned, std::size_t> edges_by_faces(const TileMesh& mesh) {
  std::map<std::pair<VertexNumber, VertexNumber>, unsigned> edges;
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (mesh.removed(f)) continue;
    const FaceVertices& face = mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(face[i], face[(i + 1) % 3])];
  }
  std::map<unsigned, std::size_t> counts;
  for (const auto& [edge, faces] : edges) ++counts[faces];
  return counts;
}

// Down to so many faces, or as far as it goes.
inline std::vector<DoneCollapse> decimate(TileMesh& mesh, Refine cost, std::uint64_t faces) {
  DecimationSettings settings;
  settings.cost = cost;
  settings.single = false;
  std::vector<DoneCollapse> log;
  Decimation::make(mesh, {}, settings)->run({faces}, [&](const DoneCollapse& done) {
    log.push_back(done);
    return true;
  });
  return log;
}

}  // namespace winnow::test
