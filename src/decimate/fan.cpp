#include "decimate/fan.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

// Goes on from the last neighbour as far as edges lead. False where it comes back to one but the
// first.
bool Fan::extend() {
  for (bool found = true; found && !closed_;) {
    found = false;
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      auto [a, b] = rim_[i];
      if (b == ring_.back()) std::swap(a, b);
      if (a != ring_.back()) continue;
      rim_[i] = rim_.back();
      rim_.pop_back();
      found = true;
      if (b == ring_.front()) {
        closed_ = true;
      } else if (std::find(ring_.begin(), ring_.end(), b) != ring_.end()) {
        return false;
      } else {
        ring_.push_back(b);
      }
      break;
    }
  }
  return true;
}

bool Fan::find(const TileMesh& mesh, VertexNumber v) {
  if (mesh.locked(v) || mesh.hub(v)) return false;
  rim_.clear();
  ring_.clear();
  loose_.clear();
  closed_ = false;
  mesh.for_each_corner(
      v, [&](FaceNumber, VertexNumber w, VertexNumber x) { rim_.emplace_back(w, x); });
  if (rim_.empty()) return false;
  ring_.push_back(rim_.front().first);
  if (!extend()) return false;
  if (!closed_) {
    std::reverse(ring_.begin(), ring_.end());
    if (!extend()) return false;
  }
  if (!rim_.empty() || ring_.size() < (closed_ ? 3 : 2)) return false;
  look(mesh, v);
  return true;
}

bool Fan::find_loose(const TileMesh& mesh, VertexNumber v) {
  if (mesh.locked(v) || mesh.hub(v) || !mesh.has_faces(v)) return false;
  ring_.clear();
  loose_.clear();
  closed_ = true;
  const auto place_of = [this](VertexNumber w) {
    const auto at = std::find(ring_.begin(), ring_.end(), w) - ring_.begin();
    if (static_cast<std::size_t>(at) == ring_.size()) ring_.push_back(w);
    return static_cast<std::uint32_t>(at);
  };
  mesh.for_each_corner(v, [&](FaceNumber, VertexNumber w, VertexNumber x) {
    const std::uint32_t first = place_of(w);
    loose_.push_back({first, place_of(x)});
  });
  look(mesh, v);
  return true;
}

void Fan::look(const TileMesh& mesh, VertexNumber v) {
  const Point& from = mesh.position(v);
  for (std::size_t axis = 0; axis < 3; ++axis) off_[axis] = std::abs(from[axis]);
  seen_.clear();
  for (const VertexNumber w : ring_) {
    const Point& position = mesh.position(w);
    for (std::size_t axis = 0; axis < 3; ++axis)
      off_[axis] = std::max(off_[axis], std::abs(position[axis]));
    seen_.push_back(position - from);
  }
  // Of both ends.
  off_ = 2 * rounding_ * off_;
}

FanShape shape_of(const FanView& fan) {
  FanShape shape;
  if (!fan.closed) shape.perimeter = length(fan.seen.back() - fan.seen.front());
  Point sum{};
  for (std::size_t i = 0; i < fan.faces(); ++i) {
    const auto [a, b] = fan.ends(i);
    const Point doubled = cross(fan.seen[a], fan.seen[b]);
    sum = sum + 0.5 * doubled;
    shape.area += length(doubled) / 2;
    shape.perimeter += length(fan.seen[b] - fan.seen[a]);
  }
  if (!(shape.area > 0)) return shape;
  const Point mean = unit(sum);
  // 1 - |sum| / area, as the mean of what each face loses: the difference cancels where little is
  // lost.
  double lost = 0;
  for (std::size_t i = 0; i < fan.faces(); ++i) {
    const auto [a, b] = fan.ends(i);
    const Point doubled = cross(fan.seen[a], fan.seen[b]);
    const Point apart = unit(doubled) - mean;
    lost += length(doubled) / 2 * dot(apart, apart) / 2;
  }
  shape.spread = dot(mean, mean) > 0 ? std::min(1.0, lost / shape.area) : 1;
  return shape;
}

double boundary_height(const FanView& fan) {
  const Point& a = fan.seen.front();
  const Point& b = fan.seen.back();
  const Point along = b - a;
  if (dot(a, along) >= 0) return length(a);
  if (dot(b, along) <= 0) return length(b);
  const Point doubled = cross(a, b);
  bool straight = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t y = (axis + 1) % 3;
    const std::size_t z = (axis + 2) % 3;
    straight &= std::abs(doubled[axis]) <= fan.off[y] * (std::abs(a[z]) + std::abs(b[z])) +
                                               fan.off[z] * (std::abs(a[y]) + std::abs(b[y]));
  }
  return straight ? 0 : length(doubled) / length(along);
}

}  // namespace winnow
