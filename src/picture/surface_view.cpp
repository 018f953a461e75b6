#include "picture/surface_view.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

SurfaceView::SurfaceView(const Frame& frame, std::size_t width, std::size_t height)
    : camera_(frame.camera),
      light_(unit(camera_.towards + (0.5 * camera_.up - 0.4 * camera_.right))),
      width_(width),
      height_(height),
      all_(width * height),
      rows_(std::make_unique<std::mutex[]>(height)) {
  const Point middle = 0.5 * (frame.box.low + frame.box.high);
  centre_ = middle[0] * camera_.right + (middle[1] * camera_.up + middle[2] * camera_.towards);
  const Point size = frame.box.high - frame.box.low;
  constexpr double share = 0.96;
  const double across = size[0] > 0 ? share * static_cast<double>(width) / size[0] : 0;
  const double upright = size[1] > 0 ? share * static_cast<double>(height) / size[1] : 0;
  scale_ = across > 0 && upright > 0 ? std::min(across, upright) : std::max(across, upright);
  if (scale_ == 0) scale_ = 1;
}

void SurfaceView::draw(const Triangle& face, std::uint64_t number,
                       const std::array<double, 3>& values) {
  std::array<double, 3> x{};
  std::array<double, 3> y{};
  std::array<double, 3> depth{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Point p = camera_.seen(face[corner] - centre_);
    x[corner] = middle_column() + scale_ * p[0];
    y[corner] = middle_row() - scale_ * p[1];
    depth[corner] = p[2];
  }
  const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  if (area == 0 || !std::isfinite(area)) return;
  // Pixels by their centres.
  const auto first = [&](const std::array<double, 3>& of) {
    return static_cast<std::size_t>(
        std::max(0.0, std::ceil(std::min({of[0], of[1], of[2]}) - 0.5)));
  };
  const auto last = [&](const std::array<double, 3>& of, std::size_t end) {
    return std::min(static_cast<double>(end), std::floor(std::max({of[0], of[1], of[2]}) + 0.5));
  };
  const Point normal = unit(doubled_area(face));
  const double side = dot(normal, camera_.towards) < 0 ? -1 : 1;
  const auto light = static_cast<float>(std::max(0.0, side * dot(normal, light_)));
  for (std::size_t row = first(y); static_cast<double>(row) < last(y, height_); ++row) {
    const double py = static_cast<double>(row) + 0.5;
    std::unique_lock<std::mutex> lock(rows_[row], std::defer_lock);
    for (std::size_t column = first(x); static_cast<double>(column) < last(x, width_); ++column) {
      const double px = static_cast<double>(column) + 0.5;
      const double b = ((px - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (py - y[0])) / area;
      const double c = ((x[1] - x[0]) * (py - y[0]) - (px - x[0]) * (y[1] - y[0])) / area;
      const double a = 1 - b - c;
      if (a < 0 || b < 0 || c < 0) continue;
      const double near = a * depth[0] + b * depth[1] + c * depth[2];
      if (!lock.owns_lock()) lock.lock();
      Pixel& pixel = all_[row * width_ + column];
      if (near < pixel.depth || (near == pixel.depth && number > pixel.number)) continue;
      pixel = {near, number, static_cast<float>(a * values[0] + b * values[1] + c * values[2]),
               light};
    }
  }
}

void SurfaceView::revalue(const std::function<double(const Point&)>& value,
                          const std::function<void()>& begin_row) {
  parallel_for(height_, [&](std::size_t row) {
    begin_row();
    for (std::size_t column = 0; column < width_; ++column) {
      Pixel& pixel = all_[row * width_ + column];
      if (!std::isfinite(pixel.depth)) continue;
      const double across = (static_cast<double>(column) + 0.5 - middle_column()) / scale_;
      const double above = (middle_row() - static_cast<double>(row) - 0.5) / scale_;
      pixel.value = static_cast<float>(
          value(centre_ +
                (across * camera_.right + (above * camera_.up + pixel.depth * camera_.towards))));
    }
  });
}

void SurfaceView::paint(Image& image, std::size_t left, std::size_t top, double most) const {
  for (std::size_t row = 0; row < height_; ++row) {
    for (std::size_t column = 0; column < width_; ++column) {
      const Pixel& pixel = all_[row * width_ + column];
      if (!std::isfinite(pixel.depth)) continue;
      Color color = viridis(static_cast<double>(pixel.value), most);
      for (std::uint8_t& channel : color)
        channel = static_cast<std::uint8_t>(channel * (0.5F + 0.5F * pixel.light));
      image.set(left + column, top + row, color);
    }
  }
}

}  // namespace winnow
