// From where surfaces are seen, and where they are seen.
#pragma once

#include <winnow/compare.hpp>

#include "base/box.hpp"
#include "base/vector.hpp"
#include "read/good_faces.hpp"

#include <array>
#include <mutex>
#include <span>

namespace winnow {

// Rays are parallel. The three directions have length 1 and right angles between them.
struct Camera {
  Point right{}, up{}, towards{};  // towards the viewer

  [[nodiscard]] Point seen(const Point& point) const {
    return {dot(point, right), dot(point, up), dot(point, towards)};
  }
};

enum class Upright { y, z };
// `viewer` is the direction to the viewer for View::from, of any length but zero.
Camera camera_for(View view, const Point& viewer, Upright upright);

// A camera with a box around everything that it is to see, in its own directions.
struct Frame {
  Camera camera;
  Box box;
};

// Finds the frame of faces that come in any order: y is up, or z for what is flat.
class Framing {
 public:
  Framing(View view, const Point& viewer);

  void add(std::span<const NumberedFace> faces);  // from any thread
  [[nodiscard]] Frame frame() const;

 private:
  // Which of both is the right one only the whole box tells.
  std::array<Frame, 2> frames_;
  Box box_;
  std::mutex mutex_;
};

}  // namespace winnow
