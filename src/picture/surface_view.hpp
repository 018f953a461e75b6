// A surface as it is seen: what of it is in front, at each pixel.
#pragma once

#include "base/vector.hpp"
#include "picture/image.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

namespace winnow {

// Faces come one after the other, so a surface of any size can be looked at. Seen from afar, a little from
// the right and from above: y is up, or z for what is flat.
class SurfaceView {
 public:
  // The box from `low` to `high` fills a square of `pixels` by `pixels`.
  SurfaceView(const Point& low, const Point& high, std::size_t pixels);
  static std::uint64_t memory(std::size_t pixels) { return pixels * pixels * sizeof(Pixel); }

  // A face with a number of its own and a value at each corner; from any thread. Of faces that are equally
  // near the lowest number is seen, so no order of drawing shows.
  void draw(const Triangle& face, std::uint64_t number, const std::array<double, 3>& values);

  // Replaces the value at each pixel where there is a surface by that of its point; rows at once. `begin_row`
  // is called before each.
  void revalue(const std::function<double(const Point&)>& value, const std::function<void()>& begin_row);

  // Into `image`, by the heat colours of the values up to `most`, with the light beside the viewer.
  void paint(Image& image, std::size_t left, std::size_t top, double most) const;

 private:
  struct Pixel {
    double depth = -std::numeric_limits<double>::infinity();
    std::uint64_t number = 0;
    float value = 0;
    float light = 0;
  };

  Point right_{}, up_{}, towards_{}, centre_{};
  double scale_ = 0;  // pixels a unit
  std::size_t pixels_;
  std::vector<Pixel> all_;
  std::unique_ptr<std::mutex[]> rows_;
};

}  // namespace winnow
