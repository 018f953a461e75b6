// The edges of a mesh by what they cost: the cheapest first, nearly.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

// From a corner of a face to the next, in that winding: no two edges of a surface are the same.
struct FaceEdge {
  FaceNumber face;
  std::uint32_t corner;

  // As one number.
  [[nodiscard]] std::uint32_t number() const { return 4 * face + corner; }
  static FaceEdge of(std::uint32_t number) { return {number / 4, number % 4}; }

  [[nodiscard]] std::pair<VertexNumber, VertexNumber> ends(const TileMesh& mesh) const {
    const FaceVertices& vertices = mesh.face(face);
    return std::minmax(vertices[corner], vertices[(1U << corner) & 3U]);
  }
};

// Every vertex proposes one edge: of those to higher numbers the cheapest.
class PricedEdges {
 public:
  explicit PricedEdges(VertexNumber vertices) : least_(vertices), counts_(classes) {
    edges_.reserve(2 * std::size_t{vertices});
  }

  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    return vertices * (2 * sizeof(Priced) + 2 * sizeof(std::uint32_t));
  }

  void clear() {
    edges_.clear();
    std::fill(least_.begin(), least_.end(), UINT32_MAX);
    std::fill(counts_.begin(), counts_.end(), 0);
  }

  // `low`: its lower end. Prices are not below 0.
  void add(FaceEdge edge, VertexNumber low, double price) {
    if (!std::isfinite(price)) return;
    const auto key = static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(price) >> 32);
    if (key > least_[low]) return;
    least_[low] = key;
    edges_.push_back({key, low, edge.number()});
  }

  // Leaves those that are proposed. How many there are.
  std::size_t propose() {
    std::erase_if(edges_, [this](const Priced& edge) { return edge.key != least_[edge.low]; });
    for (const Priced& edge : edges_) ++counts_[class_of(edge)];
    return edges_.size();
  }

  struct Cheapest {
    std::span<const std::uint32_t> edges;  // FaceEdge::number()
    double bound = 0;                      // none of them costs as much
  };
  // Of the proposed ones so many, and those that cost nearly as much as the last: cheaper classes
  // first, the edges of a class in the order in which they were added.
  Cheapest cheapest(std::size_t wanted) {
    std::uint32_t end = 0;
    std::uint32_t count = 0;
    for (; end < classes && count < wanted; ++end) count += std::exchange(counts_[end], count);
    sorted_.resize(count);
    for (const Priced& edge : edges_) {
      if (class_of(edge) < end) sorted_[counts_[class_of(edge)]++] = edge.number;
    }
    if (end == classes) return {sorted_, std::numeric_limits<double>::infinity()};
    return {sorted_, std::bit_cast<double>(std::uint64_t{end} << (class_bits + 32))};
  }

 private:
  // The upper half of a price without its lowest bits: what is in a class differs by less than a
  // sixteenth.
  static constexpr unsigned class_bits = 16;
  static constexpr std::size_t classes = std::size_t{1} << (31 - class_bits);  // no sign

  struct Priced {
    std::uint32_t key;  // the upper half of the price
    VertexNumber low;
    std::uint32_t number;
  };
  static std::uint32_t class_of(const Priced& edge) { return edge.key >> class_bits; }

  std::vector<Priced> edges_;
  std::vector<std::uint32_t> least_;  // key that each vertex has an edge of
  std::vector<std::uint32_t> counts_;
  std::vector<std::uint32_t> sorted_;
};

}  // namespace winnow
