#include "picture/surface_view.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

SurfaceView::SurfaceView(const Point& low, const Point& high, std::size_t pixels)
    : centre_(0.5 * (low + high)),
      pixels_(pixels),
      all_(pixels * pixels),
      rows_(std::make_unique<std::mutex[]>(pixels)) {
  const Point size = high - low;
  const bool flat = size[2] < 0.5 * std::min(size[0], size[1]);
  towards_ = unit(flat ? Point{0.35, -0.8, 0.9} : Point{0.35, 0.35, 1});
  right_ = unit(cross(flat ? Point{0, 0, 1} : Point{0, 1, 0}, towards_));
  up_ = cross(towards_, right_);
  // The corners of the box stay in the square.
  double reach = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Point p = Point{(corner & 1) != 0 ? high[0] : low[0], (corner & 2) != 0 ? high[1] : low[1],
                          (corner & 4) != 0 ? high[2] : low[2]} -
                    centre_;
    reach = std::max({reach, std::abs(dot(p, right_)), std::abs(dot(p, up_))});
  }
  scale_ = reach > 0 ? 0.48 * static_cast<double>(pixels) / reach : 1;
}

void SurfaceView::draw(const Triangle& face, std::uint64_t number, const std::array<double, 3>& values) {
  const double middle = static_cast<double>(pixels_) / 2;
  std::array<double, 3> x{};
  std::array<double, 3> y{};
  std::array<double, 3> depth{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Point p = face[corner] - centre_;
    x[corner] = middle + scale_ * dot(p, right_);
    y[corner] = middle - scale_ * dot(p, up_);
    depth[corner] = dot(p, towards_);
  }
  const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  if (area == 0 || !std::isfinite(area)) return;
  // Pixels by their centres.
  const auto first = [&](const std::array<double, 3>& of) {
    return static_cast<std::size_t>(std::max(0.0, std::ceil(std::min({of[0], of[1], of[2]}) - 0.5)));
  };
  const auto last = [&](const std::array<double, 3>& of) {
    return std::min(static_cast<double>(pixels_), std::floor(std::max({of[0], of[1], of[2]}) + 0.5));
  };
  const auto light = static_cast<float>(std::abs(dot(unit(doubled_area(face)), towards_)));
  for (std::size_t row = first(y); static_cast<double>(row) < last(y); ++row) {
    const double py = static_cast<double>(row) + 0.5;
    std::unique_lock<std::mutex> lock(rows_[row], std::defer_lock);
    for (std::size_t column = first(x); static_cast<double>(column) < last(x); ++column) {
      const double px = static_cast<double>(column) + 0.5;
      const double b = ((px - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (py - y[0])) / area;
      const double c = ((x[1] - x[0]) * (py - y[0]) - (px - x[0]) * (y[1] - y[0])) / area;
      const double a = 1 - b - c;
      if (a < 0 || b < 0 || c < 0) continue;
      const double near = a * depth[0] + b * depth[1] + c * depth[2];
      if (!lock.owns_lock()) lock.lock();
      Pixel& pixel = all_[row * pixels_ + column];
      if (near < pixel.depth || (near == pixel.depth && number > pixel.number)) continue;
      pixel = {near, number, static_cast<float>(a * values[0] + b * values[1] + c * values[2]), light};
    }
  }
}

void SurfaceView::revalue(const std::function<double(const Point&)>& value,
                          const std::function<void()>& begin_row) {
  const double middle = static_cast<double>(pixels_) / 2;
  parallel_for(pixels_, [&](std::size_t row) {
    begin_row();
    for (std::size_t column = 0; column < pixels_; ++column) {
      Pixel& pixel = all_[row * pixels_ + column];
      if (!std::isfinite(pixel.depth)) continue;
      const double across = (static_cast<double>(column) + 0.5 - middle) / scale_;
      const double above = (middle - static_cast<double>(row) - 0.5) / scale_;
      pixel.value =
          static_cast<float>(value(centre_ + (across * right_ + (above * up_ + pixel.depth * towards_))));
    }
  });
}

void SurfaceView::paint(Image& image, std::size_t left, std::size_t top, double most) const {
  for (std::size_t row = 0; row < pixels_; ++row) {
    for (std::size_t column = 0; column < pixels_; ++column) {
      const Pixel& pixel = all_[row * pixels_ + column];
      if (!std::isfinite(pixel.depth)) continue;
      Color color = heat_color(static_cast<double>(pixel.value), most);
      for (std::uint8_t& channel : color)
        channel = static_cast<std::uint8_t>(channel * (0.25F + 0.75F * pixel.light));
      image.set(left + column, top + row, color);
    }
  }
}

}  // namespace winnow
