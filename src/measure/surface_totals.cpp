#include "measure/surface_totals.hpp"

#include "base/hash.hpp"
#include "measure/edge_count.hpp"

#include <algorithm>
#include <bit>

namespace winnow {

namespace {

// The opposite side has the same hash with the other sign.
std::uint64_t direction(std::uint64_t from, std::uint64_t to) {
  return mixed_hash(from + std::rotl(to, 32)) - mixed_hash(to + std::rotl(from, 32));
}

}  // namespace

std::optional<Triangle> good_face(const FaceBatch& faces, std::size_t i) {
  if (faces.status[i] != FaceStatus::good) return {};
  const Triangle t{faces.corner(0, i), faces.corner(1, i), faces.corner(2, i)};
  if (!finite(t[0]) || !finite(t[1]) || !finite(t[2])) return {};
  if (t[0] == t[1] || t[0] == t[2] || t[1] == t[2]) return {};
  return t;
}

void SurfaceTotals::add(const Triangle& face) {
  if (faces_ == 0) low_ = high_ = face[0];
  ++faces_;
  for (const Point& p : face) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], p[axis]);
      high_[axis] = std::max(high_[axis], p[axis]);
    }
  }
  const double area = length(doubled_area(face)) / 2;
  if (std::isfinite(area)) area_.add(area);
  const double volume = dot(face[0] - origin_, cross(face[1] - origin_, face[2] - origin_));
  if (std::isfinite(volume)) volume_.add(volume);
  const std::array<std::uint64_t, 3> end{EdgeCount::hash_position(face[0]), EdgeCount::hash_position(face[1]),
                                         EdgeCount::hash_position(face[2])};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    directions_ += direction(end[corner], end[(corner + 1) % 3]);
  }
}

void SurfaceTotals::merge(const SurfaceTotals& other) {
  if (other.faces_ == 0) return;
  if (faces_ == 0) {
    low_ = other.low_;
    high_ = other.high_;
  }
  faces_ += other.faces_;
  area_.merge(other.area_);
  volume_.merge(other.volume_);
  directions_ += other.directions_;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low_[axis] = std::min(low_[axis], other.low_[axis]);
    high_[axis] = std::max(high_[axis], other.high_[axis]);
  }
}

}  // namespace winnow
