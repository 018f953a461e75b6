// A mesh that splits are applied to and taken back from.
#pragma once

#include "progressive/split.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

// A face at a vertex.
struct RingFace {
  FarEdge far;
  std::uint32_t corner;  // 3 f + i

  friend bool operator<(const RingFace& a, const RingFace& b) {
    return a.far != b.far ? a.far < b.far : a.corner < b.corner;
  }
};

class SplitMesh {
  struct Link {
    std::uint32_t next = no_number, previous = no_number;  // corners of the same vertex
  };

 public:
  explicit SplitMesh(std::size_t words_a_vertex) : width_(words_a_vertex) {}

  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] std::uint32_t vertices() const { return static_cast<std::uint32_t>(first_.size()); }
  [[nodiscard]] std::uint32_t faces() const { return static_cast<std::uint32_t>(face_.size()); }
  [[nodiscard]] const FaceVertices& face(std::uint32_t f) const { return face_[f]; }
  [[nodiscard]] std::span<const std::uint32_t> words(std::uint32_t v) const {
    return std::span(words_).subspan(v * width_, width_);
  }
  [[nodiscard]] bool has_faces(std::uint32_t v) const { return first_[v] != no_number; }

  // Bytes that it takes, and room for so many at once.
  static std::uint64_t memory(std::uint64_t vertices, std::uint64_t faces, std::size_t width) {
    return vertices * (width + 1) * sizeof(std::uint32_t) +
           faces * (sizeof(FaceVertices) + 3 * sizeof(Link));
  }
  void reserve(std::uint64_t vertices, std::uint64_t faces);

  void add_vertex(std::span<const std::uint32_t> words);
  void add_face(const FaceVertices& face);

  // All faces at a vertex, in the order of their other corners: what a file counts by.
  void find_ring(std::uint32_t v, std::vector<RingFace>& ring) const;

  // False, and nothing is changed, where the split names what is not there.
  [[nodiscard]] bool apply(const Split& split);
  // What there is to know of a split to take it back.
  struct Undo {
    std::uint32_t anchor = no_number, new_vertices = 0, restored = 0;
    bool moves = false;
    Words before;  // the anchor's, where it moves
  };
  [[nodiscard]] Undo undo_of(const Split& split) const;
  // Takes the last split that was applied back; `split` becomes what it was.
  void take_back(const Undo& undo, Split& split);

 private:
  // The corner of the face at `v` that has these other corners; none where there is none.
  [[nodiscard]] std::uint32_t corner_at(std::uint32_t v, const FarEdge& far) const;
  // Takes the faces that move from the anchor, into handed_.
  bool find_moved(const Split& split);
  void link(std::uint32_t corner, std::uint32_t v);
  void unlink(std::uint32_t corner, std::uint32_t v);
  void hand_over(std::uint32_t corner, std::uint32_t from, std::uint32_t to);

  std::size_t width_;
  std::vector<std::uint32_t> words_;
  std::vector<FaceVertices> face_;
  std::vector<std::uint32_t> first_;  // of each vertex the first of its corners
  std::vector<Link> link_;            // of each corner
  std::vector<std::uint32_t> handed_;
};

}  // namespace winnow
