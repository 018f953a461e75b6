#include "decimate/tile_mesh.hpp"

#include <algorithm>
#include <utility>

namespace winnow {

TileMesh::TileMesh(std::vector<Point> positions, std::vector<FaceVertices> faces,
                   std::vector<std::uint8_t> locked)
    : position_(std::move(positions)),
      face_(std::move(faces)),
      locked_(std::move(locked)),
      first_(position_.size(), no_number),
      next_(3 * face_.size()),
      mark_(position_.size(), 0),
      live_faces_(face_.size()) {
  // From the back, so that every chain begins with the vertex's lowest face.
  for (FaceNumber f = face_count(); f-- > 0;) {
    for (std::uint32_t i = 3; i-- > 0;) next(4 * f + i) = std::exchange(first_[face_[f][i]], 4 * f + i);
  }
}

std::uint64_t TileMesh::memory(std::uint64_t vertices, std::uint64_t faces) {
  return vertices * (sizeof(Point) + 1 + 2 * sizeof(std::uint32_t)) +
         faces * (sizeof(FaceVertices) + 3 * sizeof(std::uint32_t));
}

std::uint32_t TileMesh::new_marks(std::uint32_t count) {
  if (UINT32_MAX - last_mark_ < count) {
    std::fill(mark_.begin(), mark_.end(), 0);
    last_mark_ = 0;
  }
  last_mark_ += count;
  return last_mark_ - count + 1;
}

TileMesh::Meeting TileMesh::meeting(VertexNumber a, VertexNumber b) {
  const std::uint32_t of_a = new_marks(3);
  const std::uint32_t of_b = of_a + 1;
  const std::uint32_t of_both = of_a + 2;
  for_each_corner(a, [&](FaceNumber, VertexNumber w, VertexNumber x) { mark_[w] = mark_[x] = of_a; });
  Meeting meeting;
  for_each_corner(b, [&](FaceNumber, VertexNumber w, VertexNumber x) {
    meeting.faces += static_cast<unsigned>((w == a) | (x == a));
    for (const VertexNumber neighbour : {w, x}) {
      const std::uint32_t mark = mark_[neighbour];
      meeting.common += mark == of_a;
      mark_[neighbour] = ((mark == of_a) | (mark == of_both)) != 0 ? of_both : of_b;
    }
  });
  for_each_corner(b, [&](FaceNumber, VertexNumber w, VertexNumber x) {
    if ((mark_[w] != of_both) | (mark_[x] != of_both)) return;
    for_each_corner(a, [&](FaceNumber, VertexNumber y, VertexNumber z) {
      meeting.falls_together |= (y == w && z == x) || (y == x && z == w);
    });
  });
  return meeting;
}

void TileMesh::unlink(VertexNumber v, FaceNumber f) {
  std::uint32_t* link = &first_[v];
  while (face_of(*link) != f) link = &next(*link);
  *link = next(*link);
}

unsigned TileMesh::collapse(const Collapse& edge) {
  position_[edge.kept] = edge.position;
  unsigned gone = 0;
  for (std::uint32_t corner = first_[edge.removed]; corner != no_number;) {
    const FaceNumber f = face_of(corner);
    const std::uint32_t following = next(corner);
    FaceVertices& face = face_[f];
    if (has(face, edge.kept)) {
      for (const VertexNumber v : face) {
        if (v != edge.removed) unlink(v, f);
      }
      face[0] = no_number;
      ++gone;
    } else {
      face[place_in_face(corner)] = edge.kept;
    }
    corner = following;
  }
  // What is left of the chain of `removed`, behind that of `kept`.
  std::uint32_t* end = &first_[edge.kept];
  while (*end != no_number) end = &next(*end);
  for (std::uint32_t corner = first_[edge.removed]; corner != no_number;) {
    const std::uint32_t following = next(corner);
    if (!removed(face_of(corner))) {
      *end = corner;
      end = &next(corner);
    }
    corner = following;
  }
  *end = no_number;
  first_[edge.removed] = no_number;
  live_faces_ -= gone;
  return gone;
}

}  // namespace winnow
