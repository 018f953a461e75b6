// What a map of vertices has to be, whatever was simplified.
#pragma once

#include <winnow/mesh.hpp>

#include "support/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

// The same faces without vertices in common, as an STL has them.
inline Shape with_own_corners(const Shape& shape) {
  Shape soup;
  for (const auto& face : shape.faces) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t corner : face) soup.vertices.push_back(shape.vertices[corner]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  return soup;
}

using FaceSet = std::set<std::array<std::int64_t, 3>>;

inline std::array<std::int64_t, 3> any_winding(std::array<std::int64_t, 3> face) {
  std::sort(face.begin(), face.end());
  return face;
}

inline FaceSet faces_of_mesh(const Mesh& mesh) {
  FaceSet faces;
  for (std::size_t i = 0; i < mesh.faces.size(); i += 3)
    faces.insert(any_winding({mesh.faces[i], mesh.faces[i + 1], mesh.faces[i + 2]}));
  return faces;
}

// Vertices of faces with three finite corners in different places.
inline std::vector<bool> used_vertices(const Shape& shape) {
  std::vector<bool> used(shape.vertices.size(), false);
  for (const auto& face : shape.faces) {
    const Point a = shape.vertices[face[0]];
    const Point b = shape.vertices[face[1]];
    const Point c = shape.vertices[face[2]];
    if (!finite(a) || !finite(b) || !finite(c) || a == b || a == c || b == c) continue;
    for (const std::uint32_t corner : face) used[corner] = true;
  }
  return used;
}

// Where the three corners of each face of the input went, if to three vertices.
inline FaceSet images_of(const Shape& input, const VertexMap& map) {
  FaceSet images;
  for (const auto& face : input.faces) {
    const std::array<std::int64_t, 3> to{map[face[0]], map[face[1]], map[face[2]]};
    const bool whole = *std::min_element(to.begin(), to.end()) >= 0;
    if (whole && to[0] != to[1] && to[0] != to[2] && to[1] != to[2]) images.insert(any_winding(to));
  }
  return images;
}

// `input` as it was stored, with vertices of its own or without vertices in common.
inline void check_map(const Shape& input, const Mesh& output, const VertexMap& map) {
  REQUIRE(map.size() == input.vertices.size());
  const auto vertices = static_cast<std::int64_t>(output.vertex_count());
  const std::vector<bool> used = used_vertices(input);
  std::vector<bool> reached(output.vertex_count(), false);
  std::uint64_t out_of_range = 0;
  std::uint64_t unused = 0;
  std::uint64_t parted = 0;
  std::map<Point, std::int64_t> at;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map[i] < -1 || map[i] >= vertices) {
      ++out_of_range;
      continue;
    }
    if (map[i] >= 0) reached[static_cast<std::size_t>(map[i])] = true;
    if (!used[i]) {
      unused += map[i] == -1 ? 0 : 1;
      continue;
    }
    const auto [same, is_new] = at.emplace(input.vertices[i], map[i]);
    parted += same->second == map[i] ? 0 : 1;
  }
  REQUIRE(out_of_range == 0);
  CHECK(unused == 0);
  CHECK(parted == 0);
  CHECK(std::count(reached.begin(), reached.end(), false) == 0);
  const FaceSet images = images_of(input, map);
  std::uint64_t without_image = 0;
  for (const auto& face : faces_of_mesh(output)) without_image += images.count(face) == 0 ? 1 : 0;
  CHECK(without_image == 0);
}

}  // namespace winnow::test
