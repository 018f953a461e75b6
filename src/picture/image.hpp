// A picture in memory.
#pragma once

#include "base/viridis.hpp"
#include "io/byte_sink.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include <cairo.h>

namespace winnow {

class Image {
 public:
  Image(std::size_t width, std::size_t height, const Color& background);
  static std::uint64_t memory(std::uint64_t pixels);  // with what writing takes

  // What lies outside of the picture is left out.
  void set(std::size_t x, std::size_t y, const Color& color);
  void fill(std::size_t x, std::size_t y, std::size_t width, std::size_t height,
            const Color& color);

  enum class Align { left, centre };
  // ASCII, in Cairo's own font, so that it looks the same on every machine. `size` is the height of
  // a line, `y` where its letters stand.
  void text(double x, double y, double size, const std::string& text, const Color& color,
            Align align = Align::left);

  void write_png(ByteSink& sink) const;

 private:
  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* pen) const { cairo_destroy(pen); }
  };

  std::size_t width_, height_;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
};

}  // namespace winnow
