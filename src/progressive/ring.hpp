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

// The faces of a ring, which is in order, side by side from the neighbour `from` on, by their
// places: no more than `most`, and no farther than to the neighbour `to` or to the end of the fan.
// Nothing where a neighbour has two faces that could be the next.
template <typename RingEntry>
void walk(std::span<const RingEntry> ring, std::uint32_t from, std::size_t most, std::uint32_t to,
          std::vector<std::uint32_t>& places) {
  places.clear();
  while (places.size() < most && (places.empty() || from != to)) {
    const auto at = std::lower_bound(
        ring.begin(), ring.end(), from,
        [](const RingEntry& entry, std::uint32_t v) { return far_of(entry)[0] < v; });
    if (at == ring.end() || far_of(*at)[0] != from) return;
    if (at + 1 != ring.end() && far_of(*(at + 1))[0] == from) return places.clear();
    places.push_back(static_cast<std::uint32_t>(at - ring.begin()));
    from = far_of(*at)[1];
  }
}

// The neighbour at which the fan that ends at `to` begins; none where it is closed.
template <typename RingEntry>
std::uint32_t beginning_of(std::span<const RingEntry> ring, std::uint32_t to) {
  for (std::size_t steps = 0; steps <= ring.size(); ++steps) {
    const auto at = std::find_if(ring.begin(), ring.end(),
                                 [to](const RingEntry& entry) { return far_of(entry)[1] == to; });
    if (at == ring.end()) return to;
    to = far_of(*at)[0];
  }
  return no_number;
}

}  // namespace winnow
