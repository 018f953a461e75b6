// The mesh that edges are collapsed in: faces by their vertices' numbers, and for every vertex a
// chain of its corners. No face needs neighbours, so that any faces at all make such a mesh, also
// ones that no surface has.
#pragma once

#include "base/hash.hpp"
#include "base/vector.hpp"
#include "mesh/face_vertices.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

using VertexNumber = std::uint32_t;  // in a tile, from 0
using FaceNumber = std::uint32_t;

// A vertex with more faces than this is a hub, until it has no more than the second number. Nothing
// that is done for each collapse walks around a hub: neighbours are collapsed into it, unless they
// are hubs too, and it stays where it is.
inline constexpr std::uint32_t most_faces_beside_hubs = 64;
inline constexpr std::uint32_t hub_no_more = 32;

// Which vertices occur once among these, in ascending order.
void keep_single(std::vector<VertexNumber>& vertices);

// A face that is left when others have gone, and its number.
struct SurvivingFace {
  FaceVertices vertices;
  FaceNumber number;
};

// One edge collapsed into one of its ends, which moves. Where both ends are the same vertex, the
// piece of the surface that has it goes as a whole (piece.hpp).
struct Collapse {
  VertexNumber kept = no_number, removed = no_number;
  Point position{};  // where `kept` goes

  [[nodiscard]] bool of_piece() const { return kept == removed; }
};

// The face v, w, x of a vertex v, in that winding, around an edge of v.
struct StarFace {
  FaceNumber number;
  VertexNumber w, x;
  bool stays;  // is not at the edge
};

// Whether a vertex has faces outside of the tile, which then are not known. It neither moves nor
// goes.
enum Lock : std::uint8_t {
  free_vertex = 0,
  closed_vertex = 1,  // no neighbour is collapsed into it
  fixed_hub = 2,      // neighbours may be
};

// Where vertices are: in a mesh, or in one frame of a sequence.
struct VertexPlaces {
  const Point* first = nullptr;  // of the vertex 0
  std::size_t apart = 1;         // from one vertex to the next

  [[nodiscard]] const Point& operator[](VertexNumber v) const { return first[v * apart]; }
  [[nodiscard]] Triangle triangle(const FaceVertices& face) const {
    return {(*this)[face[0]], (*this)[face[1]], (*this)[face[2]]};
  }
};

class TileMesh {
 public:
  // `locked`: the Lock of each vertex. Not `linked`: until link() no vertex knows its faces.
  TileMesh(std::vector<Point> positions, std::vector<FaceVertices> faces,
           std::vector<std::uint8_t> locked, bool linked = true);

  void link();
  // The faces that are left, by collapses made elsewhere; not linked any more.
  void replace_faces(std::span<const SurvivingFace> left);
  [[nodiscard]] bool linked() const { return first_.size() == position_.size(); }

  // Bytes in use at the most while collapsing, for the plan.
  static std::uint64_t memory(std::uint64_t vertices, std::uint64_t faces);

  [[nodiscard]] VertexNumber vertex_count() const {
    return static_cast<VertexNumber>(position_.size());
  }
  [[nodiscard]] FaceNumber face_count() const {
    return static_cast<FaceNumber>(face_.size());
  }  // removed too
  [[nodiscard]] std::uint64_t live_faces() const { return live_faces_; }

  [[nodiscard]] const Point& position(VertexNumber v) const { return position_[v]; }
  [[nodiscard]] VertexPlaces places() const { return {position_.data()}; }
  void move(VertexNumber v, const Point& to) { position_[v] = to; }
  [[nodiscard]] bool locked(VertexNumber v) const {
    return (flags_[v] & (closed_vertex | fixed_hub)) != 0;
  }
  [[nodiscard]] bool closed(VertexNumber v) const { return (flags_[v] & closed_vertex) != 0; }
  void lock(VertexNumber v) { flags_[v] |= closed_vertex; }
  [[nodiscard]] bool has_faces(VertexNumber v) const { return first_[v] != no_number; }
  [[nodiscard]] std::uint32_t degree(VertexNumber v) const { return degree_[v]; }  // its faces
  [[nodiscard]] bool hub(VertexNumber v) const { return (flags_[v] & hub_now) != 0; }
  // To be told how many faces a vertex has, where the mesh is not linked.
  void update_hub(VertexNumber v, std::uint32_t faces);
  [[nodiscard]] std::uint32_t hubs() const { return hubs_; }  // how many there are
  [[nodiscard]] const FaceVertices& face(FaceNumber f) const { return face_[f]; }
  [[nodiscard]] bool removed(FaceNumber f) const { return face_[f][0] == no_number; }
  [[nodiscard]] Triangle triangle(FaceNumber f) const {
    return {position_[face_[f][0]], position_[face_[f][1]], position_[face_[f][2]]};
  }

  // each(face) for the faces of `v`.
  template <typename Each>
  void for_each_face(VertexNumber v, const Each& each) const {
    steps_ += degree_[v];
    for (std::uint32_t corner = first_[v]; corner != no_number; corner = next(corner))
      each(face_of(corner));
  }

  // each(face, w, x) for the faces v, w, x of `v`, in that winding.
  template <typename Each>
  void for_each_corner(VertexNumber v, const Each& each) const {
    steps_ += degree_[v];
    for (std::uint32_t corner = first_[v]; corner != no_number; corner = next(corner)) {
      const FaceNumber f = face_of(corner);
      const std::uint32_t at = place_in_face(corner);
      const std::uint32_t following =
          (1U << at) & 3U;  // no branch on what is a toss of three sides
      each(f, face_[f][following], face_[f][3 - at - following]);
    }
  }

  // Whether some vertex that shares a face with `v` is wanted(vertex): looks no further than to the
  // first.
  template <typename Wanted>
  [[nodiscard]] bool has_neighbour(VertexNumber v, const Wanted& wanted) const {
    for (std::uint32_t corner = first_[v]; corner != no_number; corner = next(corner)) {
      ++steps_;
      const FaceVertices& face = face_[face_of(corner)];
      if (std::any_of(face.begin(), face.end(),
                      [&](VertexNumber w) { return w != v && wanted(w); }))
        return true;
    }
    return false;
  }

  // Faces at the edge between two vertices, counted no further than to `most`: around the end that
  // has fewer.
  [[nodiscard]] unsigned faces_at(VertexNumber a, VertexNumber b, unsigned most) const {
    if (degree_[b] < degree_[a]) std::swap(a, b);
    unsigned faces = 0;
    for (std::uint32_t corner = first_[a]; corner != no_number && faces < most;
         corner = next(corner)) {
      faces += has(face_[face_of(corner)], b);
      ++steps_;
    }
    return faces;
  }

  // The vertices that share a face with `v`, each once; good until the next question about
  // neighbours.
  std::span<const VertexNumber> neighbours(VertexNumber v) {
    return neighbours_that(v, [](VertexNumber) { return true; });
  }

  // Of these the ones that the edges which belong to `v` lead to. An edge belongs to its lower end,
  // one to a hub to the other end, and none to a hub.
  std::span<const VertexNumber> owned_edges(VertexNumber v) {
    if (hub(v)) return {};
    return neighbours_that(v, [this, v](VertexNumber w) {
      return ((w > v) | ((flags_[w] & hub_now) != 0)) & ((flags_[w] & closed_vertex) == 0);
    });
  }

  // The vertices that share one face with `v`, and so an edge that is open; good until the next
  // question about neighbours.
  std::span<const VertexNumber> open_neighbours(VertexNumber v);

  // Marks vertices, each once: false where it is marked already. Good until the next question about
  // neighbours.
  void mark_anew() { marking_ = new_marks(1); }
  bool mark(VertexNumber v) { return std::exchange(mark_[v], marking_) != marking_; }

  // How the faces of two vertices `a` and `b` meet.
  struct Meeting {
    unsigned faces = 0;   // at the edge between the two
    unsigned common = 0;  // vertices that share faces with both
    bool falls_together =
        false;  // a face of one and a face of the other have both other corners in common
  };
  // All faces of `a`, and those of `b` that are not at the edge.
  [[nodiscard]] Meeting meeting(std::span<const StarFace> faces_a, VertexNumber b,
                                std::span<const StarFace> faces_b);

  // The same where `a` is a hub: `faces_at_edge` are those at the edge alone. Another hub or a
  // locked vertex beside `b` that no face at the edge has counts as one beside `a`: to know would
  // take a walk.
  [[nodiscard]] Meeting meeting_at_hub(VertexNumber a, std::span<const StarFace> faces_at_edge,
                                       VertexNumber b, std::span<const StarFace> faces_b);

  // Corners that walks around vertices have met: what the time of everything here grows with.
  [[nodiscard]] std::uint64_t steps() const { return steps_; }

  // Whether every neighbour of `v` is met in an even number of its faces, so that none of its edges
  // has one face. (But for a chance of 2^-64.)
  [[nodiscard]] bool all_edges_even(VertexNumber v) const {
    std::uint64_t odd = 0;
    for_each_corner(v, [&](FaceNumber, VertexNumber w, VertexNumber x) {
      odd ^= mixed_hash(w) ^ mixed_hash(x);
    });
    return odd == 0;
  }

  // Removes the faces at the edge, hands the others of `removed` to `kept`, and moves that. Returns
  // how many faces went. Walks around `removed` alone.
  unsigned collapse(const Collapse& edge);

  // The same for many edges, none of them of a piece, of a mesh that is not linked.
  void collapse_all(std::span<const Collapse> edges);

  // Of faces at `v` that have the same other two corners, those in opposite senses go in pairs, and
  // of those in one sense one stays. Adds the ones that go to `gone`. Returns how many.
  unsigned remove_pairs(VertexNumber v, std::vector<FaceVertices>& gone);

  // Removes all faces that hang together with these vertices: `faces`. Returns how many.
  unsigned remove(std::span<const VertexNumber> vertices, std::span<const FaceNumber> faces);

 private:
  // Corner i of face f is 4 f + i, so that no division takes it apart.
  static FaceNumber face_of(std::uint32_t corner) { return corner >> 2; }
  static std::uint32_t place_in_face(std::uint32_t corner) { return corner & 3; }
  static std::size_t place_of(std::uint32_t corner) { return corner - (corner >> 2); }  // 3 f + i
  [[nodiscard]] std::uint32_t next(std::uint32_t corner) const {
    return link_[place_of(corner)].next;
  }

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
  void unlink(VertexNumber v, std::uint32_t corner);
  void remove_face(FaceNumber f);
  // Whether it takes a walk, or another tile, to know what is beside it.
  [[nodiscard]] bool unknown(VertexNumber v) const { return flags_[v] != 0; }

  static constexpr std::uint8_t hub_now = 4;  // beside its Lock

  struct Link {
    std::uint32_t next = no_number, previous = no_number;  // corners of the same vertex
  };
  std::vector<Point> position_;
  std::vector<FaceVertices> face_;
  std::vector<std::uint8_t> flags_;   // Lock, and hub_now
  std::vector<std::uint32_t> first_;  // of each vertex the first of its corners
  std::vector<std::uint32_t> degree_;
  std::vector<Link> link_;           // of each corner, three a face
  std::vector<std::uint32_t> mark_;  // which question a vertex was last met by
  std::uint32_t last_mark_ = 0;
  std::uint32_t marking_ = 0;  // by mark()
  std::uint32_t hubs_ = 0;
  std::vector<VertexNumber> neighbours_;
  std::uint64_t live_faces_ = 0;
  mutable std::uint64_t steps_ = 0;
};

}  // namespace winnow
