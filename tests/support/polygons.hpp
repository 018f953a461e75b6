// Meshes that tests write and readers read: polygons over vertices, and the triangles they should
// become.
#pragma once

#include "read/face_batch.hpp"
#include "support/random.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace winnow::test {

using Point = std::array<double, 3>;

struct Polygons {
  std::vector<Point> vertices;
  std::vector<std::vector<std::int64_t>> faces;
};

// A triangle as a reader gives it. Positions count only where the status is good.
struct SeenFace {
  FaceStatus status = FaceStatus::good;
  std::array<Point, 3> corner{};
};

inline const Polygons unit_square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                  {{0, 1, 2}, {0, 2, 3}}};

// Empty where both are the same, to the bit (any two NaN are).
std::string difference(const std::vector<SeenFace>& a, const std::vector<SeenFace>& b);
std::string difference(const std::vector<Point>& a, const std::vector<Point>& b);

// Fans, by the definition.
std::vector<SeenFace> as_triangles(const Polygons& mesh);

// Strips, with -1 where a new one begins: every second triangle is mirrored, and none repeats an
// index.
std::vector<SeenFace> as_strips(const Polygons& mesh);

// Vertices anywhere in a box of this half side; polygons of 3 to `most` corners.
Polygons random_polygons(Random& random, std::size_t vertices, std::size_t faces, std::size_t most,
                         double half = 100);

}  // namespace winnow::test
