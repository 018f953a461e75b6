// A picture in memory.
#pragma once

#include "base/heat_color.hpp"
#include "io/byte_sink.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace winnow {

class Image {
 public:
  Image(std::size_t width, std::size_t height, const Color& background);

  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] std::size_t height() const { return height_; }

  // What lies outside of the picture is left out.
  void set(std::size_t x, std::size_t y, const Color& color);
  void fill(std::size_t x, std::size_t y, std::size_t width, std::size_t height, const Color& color);

  // Digits, signs, points, `e` and `%` in seven segments, so that no font has to be there. Returns the width;
  // other characters are left blank.
  std::size_t number(std::size_t x, std::size_t y, std::size_t height, std::string_view text,
                     const Color& color);

  void write_png(ByteSink& sink) const;

 private:
  std::size_t width_, height_;
  std::vector<std::uint8_t> bytes_;  // rows from the top, three a pixel
};

}  // namespace winnow
