// A surface as it is seen: what of it is in front, at each pixel.
#pragma once

#include "base/vector.hpp"
#include "picture/camera.hpp"
#include "picture/image.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

namespace winnow {

// Faces come one after the other, so a surface of any size can be looked at.
class SurfaceView {
 public:
  // The frame's box is as large as fits, with a narrow margin around it.
  SurfaceView(const Frame& frame, std::size_t width, std::size_t height);
  static std::uint64_t memory(std::uint64_t pixels) { return pixels * sizeof(Pixel); }

  // A face with a number of its own and a value at each corner; from any thread. Of faces that are
  // equally near the lowest number is seen, so no order of drawing shows.
  void draw(const Triangle& face, std::uint64_t number, const std::array<double, 3>& values);

  // Replaces the value at each pixel where there is a surface by that of its point; rows at once.
  // `begin_row` is called before each.
  void revalue(const std::function<double(const Point&)>& value,
               const std::function<void()>& begin_row);

  // Into `image`, by the colours of the values up to `most`, with a light above the viewer's left
  // shoulder.
  void paint(Image& image, std::size_t left, std::size_t top, double most) const;

 private:
  struct Pixel {
    double depth = -std::numeric_limits<double>::infinity();
    std::uint64_t number = 0;
    float value = 0;
    float light = 0;
  };

  [[nodiscard]] double middle_column() const { return static_cast<double>(width_) / 2; }
  [[nodiscard]] double middle_row() const { return static_cast<double>(height_) / 2; }

  Camera camera_;
  Point centre_{}, light_{};
  double scale_ = 0;  // pixels a unit
  std::size_t width_, height_;
  std::vector<Pixel> all_;
  std::unique_ptr<std::mutex[]> rows_;
};

}  // namespace winnow
