// The faces around a vertex in the order of their other corners, as who encodes a split has them
// and as who decodes it.
#pragma once

#include "progressive/split_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

inline const FarEdge& far_of(const FarEdge& far) {
  return far;
}
inline const FarEdge& far_of(const RingFace& face) {
  return face.far;
}

template <typename RingEntry>
void find_neighbours(std::span<const RingEntry> ring, std::vector<std::uint32_t>& out) {
  out.clear();
  for (const RingEntry& entry : ring)
    out.insert(out.end(), far_of(entry).begin(), far_of(entry).end());
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

// The faces of a ring, which is in order, side by side from the one at `first` on, by their places:
// no more than `most`, and no further than to the end of the fan, or to where a neighbour has two
// faces that could be the next.
template <typename RingEntry>
void walk(std::span<const RingEntry> ring, std::size_t first, std::size_t most,
          std::vector<std::uint32_t>& places) {
  places.assign(1, static_cast<std::uint32_t>(first));
  while (places.size() < most) {
    const std::uint32_t from = far_of(ring[places.back()])[1];
    const auto at = std::lower_bound(
        ring.begin(), ring.end(), from,
        [](const RingEntry& entry, std::uint32_t v) { return far_of(entry)[0] < v; });
    if (at == ring.end() || far_of(*at)[0] != from) return;
    if (at + 1 != ring.end() && far_of(*(at + 1))[0] == from) return;
    const auto place = static_cast<std::uint32_t>(at - ring.begin());
    if (std::find(places.begin(), places.end(), place) != places.end()) return;
    places.push_back(place);
  }
}

}  // namespace winnow
