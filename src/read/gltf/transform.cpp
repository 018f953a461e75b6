#include "read/gltf/transform.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

GltfTransform gltf_transform(const Point& translation, const std::array<double, 4>& rotation,
                             const Point& scale) {
  GltfTransform result = gltf_identity;
  const auto [x, y, z, w] = rotation;
  const double square = x * x + y * y + z * z + w * w;
  if (square > 0 && std::isfinite(square)) {
    const auto part = [square](double value) { return value / square; };
    result[0] = {part(w * w + x * x - y * y - z * z), part(2 * (x * y - z * w)),
                 part(2 * (x * z + y * w)), 0};
    result[1] = {part(2 * (x * y + z * w)), part(w * w - x * x + y * y - z * z),
                 part(2 * (y * z - x * w)), 0};
    result[2] = {part(2 * (x * z - y * w)), part(2 * (y * z + x * w)),
                 part(w * w - x * x - y * y + z * z), 0};
  }
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) result[row][column] *= scale[column];
    result[row][3] = translation[row];
  }
  return result;
}

GltfTransform operator*(const GltfTransform& a, const GltfTransform& b) {
  GltfTransform product{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      product[row][column] = a[row][0] * b[0][column] + a[row][1] * b[1][column] +
                             a[row][2] * b[2][column] + (column == 3 ? a[row][3] : 0.0);
    }
  }
  return product;
}

Point transformed(const GltfTransform& transform, const Point& p) {
  Point result{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& row = transform[axis];
    result[axis] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
  }
  return result;
}

GltfTurn::GltfTurn(const GltfTransform& transform) {
  std::array<Point, 3> linear{};
  double largest = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      linear[row][column] = transform[row][column];
      largest = std::max(largest, std::abs(transform[row][column]));
    }
  }
  stays_ = linear == std::array<Point, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  // Products of what is scaled so do not overflow.
  if (largest > 0 && std::isfinite(largest)) {
    for (Point& row : linear) {
      for (double& value : row) value /= largest;
    }
  }
  // The cofactors are the transpose of the inverse times the determinant. Unlike it they are there
  // also where everything is pressed flat.
  rows_ = {cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1])};
  mirrors_ = dot(linear[0], rows_[0]) < 0;
  for (Point& row : rows_) row = (mirrors_ ? -1.0 : 1.0) * row;
}

Point GltfTurn::normal(const Point& here) const {
  if (stays_) return here;
  // By the sum with 0, no -0 comes of a 0 that is mirrored.
  return unit(Point{dot(rows_[0], here), dot(rows_[1], here), dot(rows_[2], here)} + Point{});
}

}  // namespace winnow
