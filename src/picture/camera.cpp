#include "picture/camera.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

// Of vectors of any length, as far as doubles reach.
Point direction(const Point& p) {
  const double most = std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return unit({p[0] / most, p[1] / most, p[2] / most});
}

}  // namespace

Camera camera_for(View view, const Point& viewer, Upright upright) {
  const Point sky = upright == Upright::y ? Point{0, 1, 0} : Point{0, 0, 1};
  const Point front = upright == Upright::y ? Point{0, 0, 1} : Point{0, -1, 0};
  Camera camera;
  switch (view) {
    case View::front:
      camera.towards = front;
      break;
    case View::top:
      camera.towards = sky;
      break;
    case View::iso:
      camera.towards = unit(Point{1, 0, 0} + (front + sky));
      break;
    case View::from:
      camera.towards = direction(viewer);
      break;
  }
  // Seen from right above, the front is below.
  constexpr double nearly_upright = 1e-6;
  const bool along = length(cross(sky, camera.towards)) < nearly_upright;
  const Point above = along ? (dot(sky, camera.towards) > 0 ? -1.0 : 1.0) * front : sky;
  camera.right = unit(cross(above, camera.towards));
  camera.up = cross(camera.towards, camera.right);
  return camera;
}

Framing::Framing(View view, const Point& viewer)
    : frames_{Frame{camera_for(view, viewer, Upright::y), {}},
              Frame{camera_for(view, viewer, Upright::z), {}}} {}

void Framing::add(std::span<const NumberedFace> faces) {
  std::array<Box, 2> seen;
  Box box;
  for (const NumberedFace& face : faces) {
    for (const Point& corner : face.corner) {
      box.add(corner);
      for (std::size_t i = 0; i < 2; ++i) seen[i].add(frames_[i].camera.seen(corner));
    }
  }
  const std::scoped_lock lock(mutex_);
  box_.add(box);
  for (std::size_t i = 0; i < 2; ++i) frames_[i].box.add(seen[i]);
}

Frame Framing::frame() const {
  const Point size = box_.high - box_.low;
  const bool flat = size[2] < 0.5 * std::min(size[0], size[1]);
  return frames_[flat ? 1 : 0];
}

}  // namespace winnow
