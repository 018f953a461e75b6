#include "decimate/best_fit_plane.hpp"

#include <array>
#include <cstddef>

namespace winnow {

namespace {

using Matrix = std::array<Point, 3>;

// What is left beside the diagonal is rounding.
constexpr double rounding = 1e-32;
// Each pass squares what is left; a handful is the rule.
constexpr int most_passes = 12;

// Turns the axes p and q so that m[p][q] becomes 0; the rows of `axes` are the axes.
void rotate(Matrix& m, Matrix& axes, std::size_t p, std::size_t q) {
  if (m[p][q] == 0) return;
  const double ratio = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double tangent = (ratio < 0 ? -1 : 1) / (std::abs(ratio) + std::sqrt(1 + ratio * ratio));
  const double cosine = 1 / std::sqrt(1 + tangent * tangent);
  const double sine = tangent * cosine;
  const std::size_t r = 3 - p - q;
  const double across = m[p][q];
  const double rp = m[r][p];
  const double rq = m[r][q];
  m[p][p] -= tangent * across;
  m[q][q] += tangent * across;
  m[p][q] = m[q][p] = 0;
  m[r][p] = m[p][r] = cosine * rp - sine * rq;
  m[r][q] = m[q][r] = sine * rp + cosine * rq;
  const Point axis_p = axes[p];
  axes[p] = cosine * axis_p - sine * axes[q];
  axes[q] = sine * axis_p + cosine * axes[q];
}

}  // namespace

// The plane goes through the mean of the points, upright on the axis along which they spread least: the
// eigenvector of their covariances, by Jacobi's rotations.
Plane best_fit_plane(std::span<const Point> points) {
  Plane plane;
  for (const Point& p : points) plane.through = plane.through + p;
  plane.through = (1 / static_cast<double>(points.size())) * plane.through;
  Matrix spread{};
  for (const Point& p : points) {
    const Point from = p - plane.through;
    for (std::size_t i = 0; i < 3; ++i) spread[i] = spread[i] + from[i] * from;
  }
  Matrix axes{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  for (int pass = 0; pass < most_passes; ++pass) {
    const double beside =
        spread[0][1] * spread[0][1] + spread[0][2] * spread[0][2] + spread[1][2] * spread[1][2];
    const double along =
        spread[0][0] * spread[0][0] + spread[1][1] * spread[1][1] + spread[2][2] * spread[2][2];
    if (!(beside > rounding * along)) break;
    rotate(spread, axes, 0, 1);
    rotate(spread, axes, 0, 2);
    rotate(spread, axes, 1, 2);
  }
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (spread[i][i] < spread[least][least]) least = i;
  }
  plane.normal = axes[least];
  return plane;
}

}  // namespace winnow
