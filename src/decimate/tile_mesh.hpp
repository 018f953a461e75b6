// The mesh that edges are collapsed in: faces by their vertices' numbers, and for every vertex a chain of its
// corners. No face needs neighbours, so that any faces at all make such a mesh, also ones that no surface
// has.
#pragma once

#include "base/hash.hpp"
#include "base/vector.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

using VertexNumber = std::uint32_t;  // in a tile, from 0
using FaceNumber = std::uint32_t;
using FaceVertices = std::array<VertexNumber, 3>;

inline constexpr std::uint32_t no_number = UINT32_MAX;

inline bool has(const FaceVertices& face, VertexNumber v) {
  return face[0] == v || face[1] == v || face[2] == v;
}

// The same face with its lowest number first.
inline FaceVertices lowest_first(FaceVertices face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

// One edge collapsed into one of its ends, which moves.
struct Collapse {
  VertexNumber kept = no_number, removed = no_number;
  Point position{};  // where `kept` goes
};

// The face v, w, x of a vertex v, in that winding, around an edge of v.
struct StarFace {
  FaceNumber number;
  VertexNumber w, x;
  bool stays;  // is not at the edge
};

class TileMesh {
 public:
  // `locked` vertices, one byte each, belong to faces outside of the tile: they neither move nor go, and no
  // neighbour is collapsed into them.
  TileMesh(std::vector<Point> positions, std::vector<FaceVertices> faces, std::vector<std::uint8_t> locked);

  // Bytes in use at the most while collapsing, for the plan.
  static std::uint64_t memory(std::uint64_t vertices, std::uint64_t faces);

  [[nodiscard]] VertexNumber vertex_count() const { return static_cast<VertexNumber>(position_.size()); }
  [[nodiscard]] FaceNumber face_count() const {
    return static_cast<FaceNumber>(face_.size());
  }  // removed too
  [[nodiscard]] std::uint64_t live_faces() const { return live_faces_; }

  [[nodiscard]] const Point& position(VertexNumber v) const { return position_[v]; }
  [[nodiscard]] bool locked(VertexNumber v) const { return locked_[v] != 0; }
  void lock(VertexNumber v) { locked_[v] = 1; }
  [[nodiscard]] bool has_faces(VertexNumber v) const { return first_[v] != no_number; }
  [[nodiscard]] const FaceVertices& face(FaceNumber f) const { return face_[f]; }
  [[nodiscard]] bool removed(FaceNumber f) const { return face_[f][0] == no_number; }
  [[nodiscard]] Triangle triangle(FaceNumber f) const {
    return {position_[face_[f][0]], position_[face_[f][1]], position_[face_[f][2]]};
  }

  // each(face) for the faces of `v`.
  template <typename Each>
  void for_each_face(VertexNumber v, const Each& each) const {
    for (std::uint32_t corner = first_[v]; corner != no_number; corner = next(corner)) each(face_of(corner));
  }

  // each(face, w, x) for the faces v, w, x of `v`, in that winding.
  template <typename Each>
  void for_each_corner(VertexNumber v, const Each& each) const {
    for (std::uint32_t corner = first_[v]; corner != no_number; corner = next(corner)) {
      const FaceNumber f = face_of(corner);
      const std::uint32_t at = place_in_face(corner);
      const std::uint32_t following = (1U << at) & 3U;  // no branch on what is a toss of three sides
      each(f, face_[f][following], face_[f][3 - at - following]);
    }
  }

  // Faces at the edge between two vertices.
  [[nodiscard]] unsigned faces_at(VertexNumber a, VertexNumber b) const {
    unsigned faces = 0;
    for_each_corner(a, [&](FaceNumber, VertexNumber w, VertexNumber x) { faces += w == b || x == b; });
    return faces;
  }

  // The vertices that share a face with `v`, each once; good until the next question about neighbours.
  std::span<const VertexNumber> neighbours(VertexNumber v) {
    return neighbours_that(v, [](VertexNumber) { return true; });
  }

  // Of these the ones that the edges which belong to `v` lead to: every edge belongs to its lower end, unless
  // the other is locked.
  std::span<const VertexNumber> owned_edges(VertexNumber v) {
    return neighbours_that(v, [this, v](VertexNumber w) { return (w > v) & (locked_[w] == 0); });
  }

  // How the faces of two vertices `a` and `b` meet.
  struct Meeting {
    unsigned faces = 0;           // at the edge between the two
    unsigned common = 0;          // vertices that share faces with both
    bool falls_together = false;  // a face of one and a face of the other have both other corners in common
  };
  // All faces of `a`, and those of `b` that are not at the edge.
  [[nodiscard]] Meeting meeting(std::span<const StarFace> faces_a, VertexNumber b,
                                std::span<const StarFace> faces_b);

  // Whether every neighbour of `v` is met in an even number of its faces, so that none of its edges has one
  // face. (But for a chance of 2^-64.)
  [[nodiscard]] bool all_edges_even(VertexNumber v) const {
    std::uint64_t odd = 0;
    for_each_corner(
        v, [&](FaceNumber, VertexNumber w, VertexNumber x) { odd ^= mixed_hash(w) ^ mixed_hash(x); });
    return odd == 0;
  }

  // Removes the faces at the edge, hands the others of `removed` to `kept`, and moves that. Returns how many
  // faces went.
  unsigned collapse(const Collapse& edge);

 private:
  // Corner i of face f is 4 f + i, so that no division takes it apart.
  static FaceNumber face_of(std::uint32_t corner) { return corner >> 2; }
  static std::uint32_t place_in_face(std::uint32_t corner) { return corner & 3; }
  static std::size_t place_of(std::uint32_t corner) { return corner - (corner >> 2); }  // 3 f + i
  [[nodiscard]] std::uint32_t next(std::uint32_t corner) const { return next_[place_of(corner)]; }
  std::uint32_t& next(std::uint32_t corner) { return next_[place_of(corner)]; }

  // Whether one was met before is a coin toss, so there is no branch on it.
  template <typename Wanted>
  std::span<const VertexNumber> neighbours_that(VertexNumber v, const Wanted& wanted) {
    const std::uint32_t mark = new_marks(1);
    std::size_t count = 0;
    for_each_corner(v, [&](FaceNumber, VertexNumber w, VertexNumber x) {
      if (neighbours_.size() < count + 2) neighbours_.resize(2 * count + 16);
      for (const VertexNumber neighbour : {w, x}) {
        neighbours_[count] = neighbour;
        count += static_cast<std::size_t>((mark_[neighbour] != mark) & wanted(neighbour));
        mark_[neighbour] = mark;
      }
    });
    return {neighbours_.data(), count};
  }

  // The first of so many marks that no vertex has.
  std::uint32_t new_marks(std::uint32_t count);
  void unlink(VertexNumber v, FaceNumber f);

  std::vector<Point> position_;
  std::vector<FaceVertices> face_;
  std::vector<std::uint8_t> locked_;
  std::vector<std::uint32_t> first_;  // of each vertex the first of its corners
  std::vector<std::uint32_t> next_;   // of each corner the next of the same vertex, three a face
  std::vector<std::uint32_t> mark_;   // which question a vertex was last met by
  std::uint32_t last_mark_ = 0;
  std::vector<VertexNumber> neighbours_;
  std::uint64_t live_faces_ = 0;
};

}  // namespace winnow
