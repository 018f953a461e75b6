#include "measure/surface_totals.hpp"

#include "base/edge_hash.hpp"
#include "base/hash.hpp"

#include <bit>

namespace winnow {

namespace {

// The opposite side has the same hash with the other sign.
std::uint64_t direction(std::uint64_t from, std::uint64_t to) {
  return mixed_hash(from + std::rotl(to, 32)) - mixed_hash(to + std::rotl(from, 32));
}

}  // namespace

void SurfaceTotals::add(const Triangle& face) {
  ++faces_;
  for (const Point& p : face) box_.add(p);
  const double area = length(doubled_area(face)) / 2;
  if (std::isfinite(area)) area_.add(area);
  const double volume = dot(face[0] - origin_, cross(face[1] - origin_, face[2] - origin_));
  if (std::isfinite(volume)) volume_.add(volume);
  const std::array<std::uint64_t, 3> end{position_hash(face[0]), position_hash(face[1]),
                                         position_hash(face[2])};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    directions_ += direction(end[corner], end[(corner + 1) % 3]);
  }
}

void SurfaceTotals::merge(const SurfaceTotals& other) {
  faces_ += other.faces_;
  area_.merge(other.area_);
  volume_.merge(other.volume_);
  directions_ += other.directions_;
  box_.add(other.box_);
}

}  // namespace winnow
