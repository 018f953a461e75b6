#include "picture/image.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <span>

#include <png.h>

namespace winnow {

namespace {

// Bits of the segments: top, upper left, upper right, middle, lower left, lower right, bottom.
unsigned segments_of(char c) {
  switch (c) {
    case '0':
      return 0b1110111;
    case '1':
      return 0b0010010;
    case '2':
      return 0b1011101;
    case '3':
      return 0b1011011;
    case '4':
      return 0b0111010;
    case '5':
      return 0b1101011;
    case '6':
      return 0b1101111;
    case '7':
      return 0b1010010;
    case '8':
      return 0b1111111;
    case '9':
      return 0b1111011;
    case '-':
      return 0b0001000;
    case 'e':
      return 0b1101101;
    default:
      return 0;
  }
}

}  // namespace

Image::Image(std::size_t width, std::size_t height, const Color& background)
    : width_(width), height_(height), bytes_(3 * width * height) {
  fill(0, 0, width, height, background);
}

void Image::set(std::size_t x, std::size_t y, const Color& color) {
  if (x >= width_ || y >= height_) return;
  std::copy(color.begin(), color.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(3 * (y * width_ + x)));
}

void Image::fill(std::size_t x, std::size_t y, std::size_t width, std::size_t height, const Color& color) {
  for (std::size_t row = y; row < y + height; ++row) {
    for (std::size_t column = x; column < x + width; ++column) set(column, row, color);
  }
}

std::size_t Image::number(std::size_t x, std::size_t y, std::size_t height, std::string_view text,
                          const Color& color) {
  const std::size_t thick = std::max<std::size_t>(1, height / 7);
  const std::size_t width = height * 5 / 8;
  const std::size_t half = height / 2;
  const std::size_t start = x;
  for (const char c : text) {
    if (c == '.') {
      fill(x, y + height - thick, thick, thick, color);
      x += 2 * thick + 1;
      continue;
    }
    if (c == '%') {
      fill(x, y, 2 * thick, 2 * thick, color);
      fill(x + width - 2 * thick, y + height - 2 * thick, 2 * thick, 2 * thick, color);
      for (std::size_t i = 0; i < height; ++i)
        fill(x + width - 1 - i * (width - 1) / height, y + i, thick, 1, color);
    }
    const unsigned segments = segments_of(c);
    const auto has = [segments](unsigned bit) { return (segments >> bit & 1) != 0; };
    if (has(6)) fill(x, y, width, thick, color);
    if (has(5)) fill(x, y, thick, half, color);
    if (has(4)) fill(x + width - thick, y, thick, half, color);
    if (has(3)) fill(x, y + half - thick / 2, width, thick, color);
    if (has(2)) fill(x, y + half, thick, height - half, color);
    if (has(1)) fill(x + width - thick, y + half, thick, height - half, color);
    if (has(0)) fill(x, y + height - thick, width, thick, color);
    x += width + 2 * thick;
  }
  return x - start;
}

void Image::write_png(ByteSink& sink) const {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(width_);
  header.height = static_cast<png_uint_32>(height_);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<std::byte> packed(size);
  if (png_image_write_to_memory(&header, packed.data(), &size, 0, bytes_.data(), 0, nullptr) == 0) {
    throw Error(ErrorKind::failed, std::string("the picture could not be packed: ") + header.message);
  }
  sink.write(std::span(packed).first(size));
}

}  // namespace winnow
