#include "picture/image.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <span>

namespace winnow {

namespace {

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::failed,
                std::string("cannot draw the picture: ") + cairo_status_to_string(status));
}

// A sink behind Cairo, through which no exception may pass.
struct Behind {
  ByteSink& sink;
  std::exception_ptr failure;
};

cairo_status_t pass_on(void* behind, const unsigned char* bytes, unsigned count) noexcept {
  auto& [sink, failure] = *static_cast<Behind*>(behind);
  try {
    sink.write(std::as_bytes(std::span(bytes, count)));
  } catch (...) {
    failure = std::current_exception();
    return CAIRO_STATUS_WRITE_ERROR;
  }
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

Image::Image(std::size_t width, std::size_t height, const Color& background)
    : width_(width),
      height_(height),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                          static_cast<int>(height))) {
  check(cairo_surface_status(surface_.get()));
  fill(0, 0, width, height, background);
}

std::uint64_t Image::memory(std::uint64_t pixels) {
  constexpr std::uint64_t font_and_rows = 512 * 1024;
  return pixels * sizeof(std::uint32_t) + font_and_rows;
}

void Image::set(std::size_t x, std::size_t y, const Color& color) {
  fill(x, y, 1, 1, color);
}

void Image::fill(std::size_t x, std::size_t y, std::size_t width, std::size_t height,
                 const Color& color) {
  const std::uint32_t pixel =
      std::uint32_t{color[0]} << 16 | std::uint32_t{color[1]} << 8 | color[2];
  unsigned char* bytes = cairo_image_surface_get_data(surface_.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface_.get()));
  for (std::size_t row = y; row < std::min(y + height, height_); ++row) {
    for (std::size_t column = x; column < std::min(x + width, width_); ++column)
      std::memcpy(bytes + row * stride + column * sizeof pixel, &pixel, sizeof pixel);
  }
}

void Image::text(double x, double y, double size, const std::string& text, const Color& color,
                 Align align) {
  cairo_surface_mark_dirty(surface_.get());
  const std::unique_ptr<cairo_t, Destroy> pen(cairo_create(surface_.get()));
  cairo_select_font_face(pen.get(), "@cairo:", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(pen.get(), size);
  if (align == Align::centre) {
    cairo_text_extents_t extents{};
    cairo_text_extents(pen.get(), text.c_str(), &extents);
    x -= extents.x_advance / 2;
  }
  cairo_set_source_rgb(pen.get(), color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  cairo_move_to(pen.get(), x, y);
  cairo_show_text(pen.get(), text.c_str());
  check(cairo_status(pen.get()));
  cairo_surface_flush(surface_.get());
}

void Image::write_png(ByteSink& sink) const {
  cairo_surface_mark_dirty(surface_.get());
  Behind behind{sink, {}};
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), pass_on, &behind);
  if (behind.failure) std::rethrow_exception(behind.failure);
  check(status);
}

}  // namespace winnow
