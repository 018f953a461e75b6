// Where a glTF's nodes take points and normals.
#pragma once

#include "base/vector.hpp"

#include <array>

namespace winnow {

// Rows of a matrix that takes points to the parent's space; its last row is 0 0 0 1.
using GltfTransform = std::array<std::array<double, 4>, 3>;
inline constexpr GltfTransform gltf_identity{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

// Scaled first, then turned by a quaternion, x, y, z, w, of any length, then moved. Quarter turns
// are exact.
GltfTransform gltf_transform(const Point& translation, const std::array<double, 4>& rotation,
                             const Point& scale);

GltfTransform operator*(const GltfTransform& a, const GltfTransform& b);

Point transformed(const GltfTransform& transform, const Point& p);

// What a transform does to directions.
class GltfTurn {
 public:
  explicit GltfTurn(const GltfTransform& transform);

  // By the specification, triangles are turned with what they are mirrored by.
  [[nodiscard]] bool mirrors() const { return mirrors_; }

  // The normal there of a surface that has this one here: as it is where nothing but a place
  // changes, else as long as 1. What has no direction stays so.
  [[nodiscard]] Point normal(const Point& here) const;

 private:
  bool stays_ = false;
  bool mirrors_ = false;
  std::array<Point, 3> rows_{};  // of the transpose of the inverse, times a positive number
};

}  // namespace winnow
