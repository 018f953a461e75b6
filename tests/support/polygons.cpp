#include "support/polygons.hpp"

#include "read/polygons/polygon_cutter.hpp"

#include <cmath>

namespace winnow::test {

namespace {

bool same(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b && std::signbit(a) == std::signbit(b);
}

bool same(const Point& a, const Point& b) {
  return same(a[0], b[0]) && same(a[1], b[1]) && same(a[2], b[2]);
}

std::string text(const Point& p) {
  std::array<char, 100> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "(%.17g %.17g %.17g)", p[0], p[1], p[2]);
  return buffer.data();
}

SeenFace face_of(const Polygons& mesh, const std::array<std::int64_t, 3>& index) {
  SeenFace face;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const std::int64_t i = index[corner];
    if (i < 0 || i >= static_cast<std::int64_t>(mesh.vertices.size())) {
      face.status = FaceStatus::out_of_range;
    } else {
      face.corner[corner] = mesh.vertices[static_cast<std::size_t>(i)];
    }
  }
  return face;
}

}  // namespace

std::string difference(const std::vector<Point>& a, const std::vector<Point>& b) {
  if (a.size() != b.size())
    return std::to_string(a.size()) + " points instead of " + std::to_string(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i]))
      return "point " + std::to_string(i) + ": " + text(a[i]) + " instead of " + text(b[i]);
  }
  return "";
}

std::string difference(const std::vector<SeenFace>& a, const std::vector<SeenFace>& b) {
  if (a.size() != b.size())
    return std::to_string(a.size()) + " faces instead of " + std::to_string(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::string where = "face " + std::to_string(i) + ": ";
    if (a[i].status != b[i].status) {
      return where + "status " + std::to_string(static_cast<int>(a[i].status)) + " instead of " +
             std::to_string(static_cast<int>(b[i].status));
    }
    for (std::size_t corner = 0; corner < 3 && a[i].status == FaceStatus::good; ++corner) {
      if (!same(a[i].corner[corner], b[i].corner[corner])) {
        return where + text(a[i].corner[corner]) + " instead of " + text(b[i].corner[corner]);
      }
    }
  }
  return "";
}

std::vector<SeenFace> as_triangles(const Polygons& mesh) {
  std::vector<SeenFace> faces;
  PolygonCutter cutter;
  for (const auto& polygon : mesh.faces) {
    if (polygon.size() < 3) faces.push_back({FaceStatus::degenerate, {}});
    std::vector<Point> corners;
    for (const std::int64_t index : polygon) {
      if (index >= 0 && static_cast<std::size_t>(index) < mesh.vertices.size())
        corners.push_back(mesh.vertices[static_cast<std::size_t>(index)]);
    }
    const bool whole = polygon.size() > 3 && corners.size() == polygon.size();
    if (whole && cutter.cut(corners).size() + 2 == polygon.size()) {
      for (const auto& [a, b, c] : cutter.cut(corners))
        faces.push_back(face_of(mesh, {polygon[a], polygon[b], polygon[c]}));
      continue;
    }
    for (std::size_t i = 2; i < polygon.size(); ++i)
      faces.push_back(face_of(mesh, {polygon[0], polygon[i - 1], polygon[i]}));
  }
  return faces;
}

std::vector<SeenFace> as_strips(const Polygons& mesh) {
  std::vector<SeenFace> faces;
  for (const auto& strips : mesh.faces) {
    std::vector<std::int64_t> strip;
    for (const std::int64_t index : strips) {
      if (index == -1) {
        strip.clear();
        continue;
      }
      strip.push_back(index);
      const std::size_t n = strip.size();
      if (n < 3) continue;
      const std::int64_t a = strip[n - 3];
      const std::int64_t b = strip[n - 2];
      if (a == b || b == index || a == index) continue;
      faces.push_back(n % 2 == 1 ? face_of(mesh, {a, b, index}) : face_of(mesh, {b, a, index}));
    }
  }
  return faces;
}

Polygons random_polygons(Random& random, std::size_t vertices, std::size_t faces, std::size_t most,
                         double half) {
  Polygons mesh;
  mesh.vertices.resize(vertices);
  for (Point& p : mesh.vertices) {
    for (double& x : p) x = random.real(-half, half);
  }
  mesh.faces.resize(faces);
  for (auto& polygon : mesh.faces) {
    polygon.resize(random.between(3, most));
    for (std::int64_t& index : polygon) index = static_cast<std::int64_t>(random.below(vertices));
  }
  return mesh;
}

}  // namespace winnow::test
