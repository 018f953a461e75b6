// Of every vertex the other two corners of each of its faces, one after the other: made at once for
// all faces, read often.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

// Of the face v, w, x of a vertex v, in that winding.
struct OtherCorners {
  VertexNumber w, x;
};

class CornerLists {
 public:
  explicit CornerLists(VertexNumber vertices) : end_(vertices + std::size_t{1}) {}

  static constexpr std::uint64_t memory(std::uint64_t vertices, std::uint64_t faces) {
    return vertices * sizeof(std::uint32_t) + faces * 3 * sizeof(OtherCorners);
  }

  // `Face`: has .vertices. Faces of a vertex are in their order.
  template <typename Face>
  void make(std::span<const Face> faces) {
    std::fill(end_.begin(), end_.end(), 0);
    for (const Face& face : faces) {
      for (const VertexNumber v : face.vertices) ++end_[v + std::size_t{1}];
    }
    // First where each list begins; when it is full, where it ends.
    std::uint32_t sum = 0;
    for (std::uint32_t& end : end_) end = sum += end;
    std::copy_backward(end_.begin(), end_.end() - 1, end_.end());
    end_[0] = 0;
    corners_.resize(3 * faces.size());
    for (const Face& face : faces) {
      const auto [a, b, c] = face.vertices;
      corners_[end_[a + std::size_t{1}]++] = {b, c};
      corners_[end_[b + std::size_t{1}]++] = {c, a};
      corners_[end_[c + std::size_t{1}]++] = {a, b};
    }
  }

  [[nodiscard]] std::span<const OtherCorners> of(VertexNumber v) const {
    return {corners_.data() + end_[v], corners_.data() + end_[v + std::size_t{1}]};
  }
  [[nodiscard]] std::uint32_t degree(VertexNumber v) const {
    return end_[v + std::size_t{1}] - end_[v];
  }

 private:
  std::vector<std::uint32_t> end_;  // of vertex v at v + 1; before it the next lower one's
  std::vector<OtherCorners> corners_;
};

}  // namespace winnow
