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

TileMesh::Meeting TileMesh::meeting(std::span<const StarFace> faces_a, VertexNumber b,
                                    std::span<const StarFace> faces_b) {
  const std::uint32_t of_a = new_marks(3);
  const std::uint32_t of_b = of_a + 1;
  const std::uint32_t of_both = of_a + 2;
  for (const StarFace& face : faces_a) mark_[face.w] = mark_[face.x] = of_a;
  Meeting meeting;
  const auto meet = [&](VertexNumber neighbour) {
    const std::uint32_t mark = mark_[neighbour];
    meeting.common += mark == of_a;
    mark_[neighbour] = ((mark == of_a) | (mark == of_both)) != 0 ? of_both : of_b;
  };
  for (const StarFace& face : faces_a) {
    if (face.stays) continue;
    ++meeting.faces;
    meet(face.w == b ? face.x : face.w);
  }
  for (const StarFace& face : faces_b) {
    meet(face.w);
    meet(face.x);
  }
  for (const StarFace& face : faces_b) {
    if ((mark_[face.w] != of_both) | (mark_[face.x] != of_both)) continue;
    for (const StarFace& other : faces_a) {
      meeting.falls_together |=
          (other.w == face.w && other.x == face.x) || (other.w == face.x && other.x == face.w);
    }
  }
  return meeting;
}

void TileMesh::unlink(VertexNumber v, FaceNumber f) {
  std::uint32_t* link = &first_[v];
  while (face_of(*link) != f) link = &next(*link);
  *link = next(*link);
}

unsigned TileMesh::collapse(const Collapse& edge) {
  const auto [kept, removed, position] = edge;
  position_[kept] = position;
  unsigned gone = 0;
  std::uint32_t* link = &first_[kept];
  while (*link != no_number) {
    const FaceNumber f = face_of(*link);
    FaceVertices& face = face_[f];
    if (has(face, removed)) {
      *link = next(*link);
      for (const VertexNumber v : face) {
        if (v != kept && v != removed) unlink(v, f);
      }
      face[0] = no_number;
      ++gone;
    } else {
      link = &next(*link);
    }
  }
  // What is left of the chain of `removed`, behind that of `kept`.
  for (std::uint32_t corner = first_[removed]; corner != no_number;) {
    const std::uint32_t following = next(corner);
    FaceVertices& face = face_[face_of(corner)];
    if (face[0] != no_number) {
      face[place_in_face(corner)] = kept;
      *link = corner;
      link = &next(corner);
    }
    corner = following;
  }
  *link = no_number;
  first_[removed] = no_number;
  live_faces_ -= gone;
  return gone;
}

}  // namespace winnow
