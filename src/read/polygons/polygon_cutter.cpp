#include "read/polygons/polygon_cutter.hpp"

#include "read/polygons/monotone_cut.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

// Triangles that overlap or leave something out differ in area from the polygon by more than this
// part.
constexpr double rounding = 1e-9;
// Where corners or edges touch, as of a hole that is linked to the outline by two edges in one
// place, corners are moved inwards by this part of the polygon's size, so that they are apart.
constexpr double nudge_of_size = 1e-7;

// On the plane of the two axes that the normal is farthest from, so that the polygon keeps its
// sense.
std::vector<PlanePoint> flattened(std::span<const Point> corners, const Point& normal, Pace& pace) {
  std::size_t up = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    up = std::abs(normal[axis]) > std::abs(normal[up]) ? axis : up;
  std::size_t u = (up + 1) % 3;
  std::size_t v = (up + 2) % 3;
  if (normal[up] < 0) std::swap(u, v);
  std::vector<PlanePoint> flat;
  flat.reserve(corners.size());
  for (const Point& corner : corners) {
    pace();
    flat.push_back({corner[u] - corners[0][u], corner[v] - corners[0][v]});
  }
  return flat;
}

PlanePoint inward_normal(const PlanePoint& from, const PlanePoint& to) {
  const double size = std::hypot(to[0] - from[0], to[1] - from[1]);
  return size > 0 ? PlanePoint{(from[1] - to[1]) / size, (to[0] - from[0]) / size} : PlanePoint{};
}

void move_inwards(std::vector<PlanePoint>& corners, double part, Pace& pace) {
  PlanePoint low = corners[0];
  PlanePoint high = corners[0];
  for (const PlanePoint& corner : corners) {
    pace();
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], corner[k]);
      high[k] = std::max(high[k], corner[k]);
    }
  }
  const double distance = part * std::hypot(high[0] - low[0], high[1] - low[1]);
  const std::vector<PlanePoint> old = corners;
  for (std::size_t i = 0; i < old.size(); ++i) {
    pace();
    const PlanePoint& before = old[i == 0 ? old.size() - 1 : i - 1];
    const PlanePoint& next = old[i + 1 == old.size() ? 0 : i + 1];
    const PlanePoint a = inward_normal(before, old[i]);
    const PlanePoint b = inward_normal(old[i], next);
    for (std::size_t k = 0; k < 2; ++k) corners[i][k] += distance * (a[k] + b[k]);
  }
}

}  // namespace

const std::vector<std::array<std::uint32_t, 3>>& PolygonCutter::cut(
    std::span<const Point> corners) {
  triangles_.clear();
  const auto is_number = [&](const Point& corner) {
    pace_();
    return finite(corner);
  };
  if (!std::all_of(corners.begin(), corners.end(), is_number)) return triangles_;
  triangles_.reserve(corners.size());
  normal_ = normal_of(corners);
  most_ = rounding * dot(normal_, normal_);
  if (fan(corners)) return triangles_;
  if (most_ > 0 && (sweep(corners, 0) || sweep(corners, nudge_of_size))) return triangles_;
  triangles_.clear();
  return triangles_;
}

Point PolygonCutter::normal_of(std::span<const Point> corners) {
  Point normal{};
  for (std::size_t i = 2; i < corners.size(); ++i) {
    pace_();
    normal = normal + cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  return normal;
}

// False where a triangle would be turned over, or has an area though the polygon has none.
bool PolygonCutter::fan(std::span<const Point> corners) {
  for (std::uint32_t i = 2; i < corners.size(); ++i) {
    pace_();
    const Point area = cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    if (dot(area, normal_) < -most_ || (most_ == 0 && dot(area, area) > 0)) return false;
    triangles_.push_back({0, i - 1, i});
  }
  return true;
}

bool PolygonCutter::sweep(std::span<const Point> corners, double nudge) {
  triangles_.clear();
  std::vector<PlanePoint> flat = flattened(corners, normal_, pace_);
  if (nudge > 0) move_inwards(flat, nudge, pace_);
  cut_by_sweep(flat, pace_, triangles_);
  return triangles_.size() == corners.size() - 2 && covers(corners);
}

bool PolygonCutter::covers(std::span<const Point> corners) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles_) {
    pace_();
    const double area = dot(cross(corners[b] - corners[a], corners[c] - corners[a]), normal_);
    if (area < -most_) return false;
    sum += area;
  }
  return std::abs(sum - dot(normal_, normal_)) <= static_cast<double>(corners.size()) * most_;
}

}  // namespace winnow
