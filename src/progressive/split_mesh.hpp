// A mesh that splits are applied to and taken back from.
#pragma once

#include "progressive/ring.hpp"
#include "progressive/split.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace winnow {

class SplitMesh {
  // Each corner knows the next of the same vertex: what is read of a face lies side by side.
  struct Face {
    FaceVertices vertices;
    std::array<std::uint32_t, 3> next;
  };

 public:
  using Memory = std::pmr::memory_resource;
  explicit SplitMesh(std::size_t words_a_vertex, Memory* memory = std::pmr::get_default_resource())
      : width_(words_a_vertex), words_(memory), face_(memory), first_(memory), before_(memory) {}
  // The same mesh in other memory, with room for so many, which has to stay.
  SplitMesh(const SplitMesh& other, Memory* memory, std::uint64_t vertices, std::uint64_t faces);

  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] std::uint32_t vertices() const { return static_cast<std::uint32_t>(first_.size()); }
  [[nodiscard]] std::uint32_t faces() const { return static_cast<std::uint32_t>(face_.size()); }
  [[nodiscard]] const FaceVertices& face(std::uint32_t f) const { return face_[f].vertices; }
  [[nodiscard]] std::span<const std::uint32_t> words(std::uint32_t v) const {
    return std::span(words_).subspan(v * width_, width_);
  }
  [[nodiscard]] bool has_faces(std::uint32_t v) const { return first_[v] != no_number; }

  // Bytes that it takes, and room for so many at once.
  static std::uint64_t memory(std::uint64_t vertices, std::uint64_t faces, std::size_t width) {
    return vertices * (width + 1) * sizeof(std::uint32_t) +
           faces * (sizeof(Face) + 3 * sizeof(std::uint32_t));
  }
  void reserve(std::uint64_t vertices, std::uint64_t faces);

  void add_vertex(std::span<const std::uint32_t> words);
  void add_face(const FaceVertices& face);

  // The faces at a vertex, in no order; of too many only some.
  void find_ring(std::uint32_t v, Ring& ring) const;

  // each(the other corners) of all faces at a vertex, in no order.
  template <typename Each>
  void for_each_face_at(std::uint32_t v, const Each& each) const {
    for (std::uint32_t corner = first_[v]; corner != no_number;) {
      const Face& face = face_[corner / 3];
      const std::uint32_t i = corner % 3;
      each(FarEdge{face.vertices[after[i]], face.vertices[after[i + 1]]});
      corner = face.next[i];
    }
  }

  // See LookAhead.
  void expect(std::uint32_t v) const {
    if (v >= vertices()) return;
    __builtin_prefetch(&first_[v]);
    __builtin_prefetch(&words_[v * width_]);
  }
  [[nodiscard]] std::uint32_t first_expected(std::uint32_t v) const {
    return v < vertices() ? expected(first_[v]) : no_number;
  }
  [[nodiscard]] std::uint32_t next_expected(std::uint32_t corner) const {
    if (corner >= 3 * faces()) return no_number;
    const Face& face = face_[corner / 3];
    __builtin_prefetch(&first_[face.vertices[after[corner % 3]]]);
    return expected(face.next[corner % 3]);
  }

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
  // Of the corners of a face that behind each, without a branch.
  static constexpr std::array<std::uint32_t, 4> after{1, 2, 0, 1};

  [[nodiscard]] std::uint32_t expected(std::uint32_t corner) const {
    if (corner != no_number) __builtin_prefetch(&face_[corner / 3]);
    return corner;
  }
  // The corner of the face at `v` that has these other corners; none where there is none.
  [[nodiscard]] std::uint32_t corner_at(std::uint32_t v, const FarEdge& far) const;
  // Takes the faces that move from the anchor, into handed_.
  bool find_moved(const Split& split);
  // Shares all corners of the anchor with a vertex that has none.
  void share_out(std::span<const Split::Corner> around, std::uint32_t anchor, std::uint32_t other);
  [[nodiscard]] std::uint32_t& next(std::uint32_t corner) {
    return face_[corner / 3].next[corner % 3];
  }
  // The corner before one of this vertex that is not its first.
  std::uint32_t before(std::uint32_t corner, std::uint32_t v);
  std::uint32_t before_far(std::uint32_t corner, std::uint32_t v);
  void link(std::uint32_t corner, std::uint32_t v);
  void unlink(std::uint32_t corner, std::uint32_t v);
  void hand_over(std::uint32_t corner, std::uint32_t from, std::uint32_t to);

  std::size_t width_;
  std::pmr::vector<std::uint32_t> words_;
  std::pmr::vector<Face> face_;
  std::pmr::vector<std::uint32_t> first_;  // of each vertex the first of its corners
  // Of corners far down the list of a vertex with very many, where the one before was found: true
  // where that one's next still is the corner.
  std::pmr::vector<std::uint32_t> before_;
  std::vector<std::uint32_t> handed_;
};

}  // namespace winnow
