#include "picture/side_by_side.hpp"

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

namespace winnow {

namespace {

constexpr std::size_t view_pixels = 720;
constexpr std::size_t width = 2 * view_pixels;
constexpr std::size_t height = view_pixels + 50;

// Three digits, for a scale.
std::string significant(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

void draw_bar(Image& image, double most) {
  constexpr std::size_t left = view_pixels / 2;
  constexpr std::size_t long_side = view_pixels;
  constexpr std::size_t top = view_pixels + 10;
  constexpr std::size_t short_side = 16;
  for (std::size_t i = 0; i < long_side; ++i)
    image.fill(left + i, top, 1, short_side,
               heat_color(static_cast<double>(i), static_cast<double>(long_side - 1)));
  constexpr Color ink{40, 40, 40};
  for (std::size_t part = 0; part <= 3; ++part) {
    const std::size_t x = left + part * (long_side - 1) / 3;
    image.fill(x, top + short_side, 1, 5, ink);
    image.number(x + 4, top + short_side + 5, 16, significant(most * static_cast<double>(part) / 3), ink);
  }
}

}  // namespace

SideBySide::SideBySide(const Box& box)
    : left_(box.low, box.high, view_pixels), right_(box.low, box.high, view_pixels) {}

std::uint64_t SideBySide::memory() {
  return 2 * SurfaceView::memory(view_pixels) + 3 * width * height * 2;
}

void SideBySide::write_png(ByteSink& sink, double most) const {
  Image image(width, height, {255, 255, 255});
  left_.paint(image, 0, 0, most);
  right_.paint(image, view_pixels, 0, most);
  draw_bar(image, most);
  image.write_png(sink);
}

}  // namespace winnow
