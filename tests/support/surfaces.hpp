// Small surfaces as triangles, turned outwards.
#pragma once

#include "base/vector.hpp"
#include "cluster/grid.hpp"
#include "support/random.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace winnow::test {

inline Point area_vector(const Triangle& t) {
  return 0.5 * cross(t[1] - t[0], t[2] - t[0]);
}

// A closed ball of about 4 n^2 faces and radius 1, with bumps where `bump` is not 0.
inline std::vector<Triangle> ball(std::size_t n, double bump = 0) {
  const auto at = [&](std::size_t row, std::size_t column) -> Point {
    const double v = std::numbers::pi * static_cast<double>(row) / static_cast<double>(n);
    const double u =
        std::numbers::pi * static_cast<double>(column % (2 * n)) / static_cast<double>(n);
    const bool pole = row == 0 || row == n;
    const double r = pole ? 1 : 1 + bump * std::sin(7 * u) * std::sin(5 * v) * std::sin(v);
    if (pole) return {0, 0, row == 0 ? 1.0 : -1.0};
    return {r * std::sin(v) * std::cos(u), r * std::sin(v) * std::sin(u), r * std::cos(v)};
  };
  std::vector<Triangle> faces;
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < 2 * n; ++column) {
      const Point a = at(row, column);
      const Point b = at(row + 1, column);
      const Point c = at(row + 1, column + 1);
      const Point d = at(row, column + 1);
      if (row + 1 < n) faces.push_back({a, b, c});
      if (row > 0) faces.push_back({a, c, d});
    }
  }
  return faces;
}

// The unit square at height z, facing up, of 2 n^2 faces.
inline std::vector<Triangle> sheet(std::size_t n, double z = 0) {
  std::vector<Triangle> faces;
  const double step = 1 / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const auto at = [&](std::size_t di, std::size_t dj) -> Point {
        return {static_cast<double>(i + di) * step, static_cast<double>(j + dj) * step, z};
      };
      faces.push_back({at(0, 0), at(1, 0), at(1, 1)});
      faces.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  }
  return faces;
}

// A closed ring with a hole through it, of 2 n m faces: n around the hole, m around the tube.
inline std::vector<Triangle> torus(std::size_t n, std::size_t m, double tube = 0.3) {
  const auto at = [&](std::size_t i, std::size_t j) -> Point {
    const double u = 2 * std::numbers::pi * static_cast<double>(i % n) / static_cast<double>(n);
    const double v = 2 * std::numbers::pi * static_cast<double>(j % m) / static_cast<double>(m);
    const double r = 1 + tube * std::cos(v);
    return {r * std::cos(u), r * std::sin(u), tube * std::sin(v)};
  };
  std::vector<Triangle> faces;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return faces;
}

inline Triangle turned(const Triangle& face) {
  return {face[0], face[2], face[1]};
}

// The unit cube, closed, of 12 n^2 faces.
inline std::vector<Triangle> cube(std::size_t n) {
  std::vector<Triangle> faces;
  for (const Triangle& face : sheet(n)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Triangle low{};
      Triangle high{};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        // A cyclic shift of the axes keeps the side that is up.
        for (std::size_t k = 0; k < 3; ++k)
          low[corner][(k + axis) % 3] = high[corner][(k + axis) % 3] = face[corner][k];
        high[corner][(2 + axis) % 3] = 1;
      }
      faces.push_back(turned(low));
      faces.push_back(high);
    }
  }
  return faces;
}

// Triangles anywhere in the unit cube, of about this size.
inline std::vector<Triangle> soup(Random& random, std::size_t count, double size) {
  std::vector<Triangle> faces(count);
  for (Triangle& face : faces) {
    const Point middle{random.unit(), random.unit(), random.unit()};
    for (Point& corner : face) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        corner[axis] = middle[axis] + size * (random.unit() - 0.5);
    }
  }
  return faces;
}

// Scaled, then moved.
inline std::vector<Triangle> placed(std::vector<Triangle> faces, double scale,
                                    const Point& offset) {
  for (Triangle& face : faces) {
    for (Point& corner : face) corner = scale * corner + offset;
  }
  return faces;
}

// Corners as a float holds them.
inline std::vector<Triangle> as_floats(std::vector<Triangle> faces) {
  for (Triangle& face : faces) {
    for (Point& corner : face) {
      for (double& x : corner) x = static_cast<float>(x);
    }
  }
  return faces;
}

inline Box box_of(const std::vector<Triangle>& faces) {
  Box box;
  for (const Triangle& face : faces) {
    for (const Point& corner : face) box.add(corner);
  }
  return box;
}

}  // namespace winnow::test
