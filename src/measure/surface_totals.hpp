// What the faces of a surface add up to, in constant memory and whatever their order.
#pragma once

#include <winnow/simplify.hpp>

#include "base/exact_sum.hpp"
#include "base/vector.hpp"
#include "read/face_batch.hpp"

#include <cstdint>
#include <optional>

namespace winnow {

// Face `i` of a batch, if all its corners exist, are finite and stand in three places.
std::optional<Triangle> good_face(const FaceBatch& faces, std::size_t i);

class SurfaceTotals {
 public:
  // Volumes are seen from `origin`: any point near the surface, so that little is lost by rounding.
  explicit SurfaceTotals(const Point& origin) : origin_(origin) {}

  void add(const Triangle& face);
  void merge(const SurfaceTotals& other);

  [[nodiscard]] std::uint64_t faces() const { return faces_; }
  [[nodiscard]] double area() const { return area_.value(); }
  [[nodiscard]] const Point& low() const { return low_; }
  [[nodiscard]] const Point& high() const { return high_; }
  [[nodiscard]] double diagonal() const { return length(high_ - low_); }

  // Whether every side of a face is met by one of the opposite direction: then the surface has an inside.
  // Told by a sum of hashes, so that it takes no memory; wrong with a chance of 2^-64.
  [[nodiscard]] bool closed() const { return faces_ > 0 && directions_ == 0; }

  // Enclosed; only for what is closed.
  [[nodiscard]] double volume() const { return volume_.value() / 6; }

 private:
  Point origin_;
  std::uint64_t faces_ = 0;
  ExactSum area_, volume_;
  std::uint64_t directions_ = 0;
  Point low_{}, high_{};
};

}  // namespace winnow
