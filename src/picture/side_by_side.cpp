#include "picture/side_by_side.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace winnow {

namespace {

constexpr Color paper{255, 255, 255};
constexpr Color ink{40, 40, 40};

// Pixels. A view covers about the same area whatever its shape.
constexpr double view_side = 720;
constexpr double longest_width = 2000, longest_height = 1440;
constexpr double least_width = 320, least_height = 60;
constexpr std::size_t label_height = 44;
constexpr double label_size = 24;
constexpr std::size_t scale_height = 112;
constexpr double scale_size = 18;

// Three digits, for a scale.
std::string significant(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

// In the rows from `top` on: what is shown, the colours, and their values in both units.
void draw_scale(Image& image, std::size_t width, std::size_t top, double most, double diagonal) {
  constexpr std::size_t units_width = 190;
  constexpr std::size_t margin = 60;
  constexpr std::size_t thickness = 18;
  const std::size_t bar = std::min<std::size_t>(720, width - units_width - 2 * margin);
  const std::size_t left = (width - bar - units_width) / 2;
  const std::size_t bar_top = top + 30;
  image.text(static_cast<double>(left), static_cast<double>(top) + 20, scale_size,
             "distance to the other mesh", ink);
  for (std::size_t i = 0; i < bar; ++i)
    image.fill(left + i, bar_top, 1, thickness,
               viridis(static_cast<double>(i), static_cast<double>(bar - 1)));
  const double lengths = static_cast<double>(bar_top + thickness) + 24;
  const double percents = lengths + 24;
  const std::size_t parts = most > 0 ? 3 : 0;
  for (std::size_t part = 0; part <= parts; ++part) {
    const std::size_t x = parts > 0 ? left + part * (bar - 1) / parts : left;
    image.fill(x, bar_top + thickness, 1, 6, ink);
    const double value =
        parts > 0 ? most * static_cast<double>(part) / static_cast<double>(parts) : 0;
    const std::string more = part == 3 ? "+" : "";
    const auto number = [&](double y, double shown) {
      image.text(static_cast<double>(x), y, scale_size, significant(shown) + more, ink,
                 Image::Align::centre);
    };
    number(lengths, value);
    number(percents, diagonal > 0 ? 100 * value / diagonal : 0);
  }
  const auto units = static_cast<double>(left + bar + margin);
  image.text(units, lengths, scale_size, "model units", ink);
  image.text(units, percents, scale_size, "% of the diagonal", ink);
}

}  // namespace

SideBySide::Layout::Layout(const Box& seen) {
  const Point size = seen.high - seen.low;
  const double aspect = std::clamp(size[1] > 0 ? size[0] / size[1] : 1e3, 1e-3, 1e3);
  const double root = std::sqrt(aspect);
  double width = std::min(view_side * root, longest_width);
  double height = std::min(view_side / root, longest_height);
  width = std::max(std::min(width, height * aspect), least_width);
  height = std::max(std::min(height, width / aspect), least_height);
  view_width = static_cast<std::size_t>(width);
  view_height = static_cast<std::size_t>(height);
  stacked = aspect > 2;
}

SideBySide::SideBySide(const Frame& frame)
    : layout_(frame.box),
      original_(frame, layout_.view_width, layout_.view_height),
      simplified_(frame, layout_.view_width, layout_.view_height) {}

std::uint64_t SideBySide::memory() {
  constexpr auto view_pixels = static_cast<std::uint64_t>(view_side * view_side);
  constexpr auto text_pixels =
      static_cast<std::uint64_t>(longest_width + 1000) * (2 * label_height + scale_height);
  return 2 * SurfaceView::memory(view_pixels) + Image::memory(2 * view_pixels + text_pixels);
}

void SideBySide::write_png(ByteSink& sink, double most, double diagonal) const {
  const std::size_t down = layout_.view_height + label_height;
  const std::size_t width = layout_.stacked ? layout_.view_width : 2 * layout_.view_width;
  const std::size_t height = layout_.stacked ? 2 * down : down;
  Image image(width, height + scale_height, paper);
  const auto show = [&](const SurfaceView& view, const char* name, std::size_t left,
                        std::size_t top) {
    image.text(static_cast<double>(left) + static_cast<double>(layout_.view_width) / 2,
               static_cast<double>(top) + 32, label_size, name, ink, Image::Align::centre);
    view.paint(image, left, top + label_height, most);
  };
  show(original_, "original", 0, 0);
  show(simplified_, "simplified", width - layout_.view_width, height - down);
  draw_scale(image, width, height, most, diagonal);
  image.write_png(sink);
}

}  // namespace winnow
