// Two surfaces in one picture, coloured by one scale.
#pragma once

#include "io/byte_sink.hpp"
#include "picture/camera.hpp"
#include "picture/image.hpp"
#include "picture/surface_view.hpp"

#include <cstddef>
#include <cstdint>

namespace winnow {

class SideBySide {
 public:
  // Both are seen from one place, as large as the frame allows: what is wide stands one above the
  // other.
  explicit SideBySide(const Frame& frame);
  static std::uint64_t memory();  // with what writing takes

  [[nodiscard]] SurfaceView& original() { return original_; }
  [[nodiscard]] SurfaceView& simplified() { return simplified_; }

  // A PNG, with a scale that shows the colours from 0 to `most`; both lengths in model units.
  void write_png(ByteSink& sink, double most, double diagonal) const;

 private:
  struct Layout {
    explicit Layout(const Box& seen);
    std::size_t view_width, view_height;
    bool stacked;
  };

  Layout layout_;
  SurfaceView original_, simplified_;
};

}  // namespace winnow
