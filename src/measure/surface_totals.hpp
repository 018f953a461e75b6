// What the faces of a surface add up to, in constant memory and whatever their order.
#pragma once

#include "base/box.hpp"
#include "base/exact_sum.hpp"
#include "base/vector.hpp"

#include <cstdint>

namespace winnow {

class SurfaceTotals {
 public:
  // Volumes are seen from `origin`: any point near the surface, so that little is lost by rounding.
  explicit SurfaceTotals(const Point& origin) : origin_(origin) {}

  void add(const Triangle& face);
  void merge(const SurfaceTotals& other);

  [[nodiscard]] std::uint64_t faces() const { return faces_; }
  [[nodiscard]] double area() const { return area_.value(); }
  [[nodiscard]] const Box& box() const { return box_; }

  // Whether every side of a face is met by one of the opposite direction: then the surface has an
  // inside. Told by a sum of hashes, so that it takes no memory; wrong with a chance of 2^-64.
  [[nodiscard]] bool closed() const { return faces_ > 0 && directions_ == 0; }

  // Enclosed; only for what is closed.
  [[nodiscard]] double volume() const { return volume_.value() / 6; }

 private:
  Point origin_;
  std::uint64_t faces_ = 0;
  ExactSum area_, volume_;
  std::uint64_t directions_ = 0;
  Box box_;
};

}  // namespace winnow
