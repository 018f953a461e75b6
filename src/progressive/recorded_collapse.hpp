// What a collapse took away, in numbers that vertices keep from round to round: a split for whoever
// reads coarse to fine.
#pragma once

#include "progressive/split_codec.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

struct RecordedCollapse {
  std::vector<std::uint32_t> gone;  // vertices; the first of them was collapsed into the anchor
  RingedSplit ringed;

  // Keeps what it has allocated.
  void clear() {
    gone.clear();
    ringed.split.clear();
    ringed.before.clear();
    ringed.ring.clear();
  }

  // each(number) for every number of a vertex, to be changed.
  template <typename Each>
  void for_each_vertex(const Each& each) {
    Split& split = ringed.split;
    if (split.anchor != no_number) each(split.anchor);
    for (std::uint32_t& v : gone) each(v);
    for (FaceVertices& face : split.restored) {
      for (std::uint32_t& v : face) each(v);
    }
    const auto each_of = [&each](std::vector<FarEdge>& faces) {
      for (FarEdge& far : faces) {
        for (std::uint32_t& v : far) each(v);
      }
    };
    if (ringed.ring.empty()) return each_of(split.moved);
    each_of(ringed.ring);
    ringed.take_moved();
  }
};

// About what it takes, in bytes.
constexpr std::size_t recorded_bytes(std::size_t width) {
  return (48 + 3 * width) * sizeof(std::uint32_t);
}

// Appends it to a list of words, and takes one out again from the front, or leaves it out.
void pack(const RecordedCollapse& collapse, Words& out);
void unpack(std::span<const std::uint32_t>& words, std::size_t width, RecordedCollapse& collapse);
void skip_packed(std::span<const std::uint32_t>& words, std::size_t width);

}  // namespace winnow
