// Two surfaces in one picture, coloured by one scale.
#pragma once

#include "base/box.hpp"
#include "io/byte_sink.hpp"
#include "picture/surface_view.hpp"

#include <cstdint>

namespace winnow {

class SideBySide {
 public:
  // Both are looked at from one place, so that `box` fills either half.
  explicit SideBySide(const Box& box);
  static std::uint64_t memory();  // with what writing takes

  [[nodiscard]] SurfaceView& left() { return left_; }
  [[nodiscard]] SurfaceView& right() { return right_; }

  // A PNG, with a bar that shows the colours from 0 to `most`.
  void write_png(ByteSink& sink, double most) const;

 private:
  SurfaceView left_, right_;
};

}  // namespace winnow
