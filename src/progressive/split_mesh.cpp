#include "progressive/split_mesh.hpp"

#include <algorithm>
#include <utility>

namespace winnow {

SplitMesh::SplitMesh(const SplitMesh& other, Memory* memory, std::uint64_t vertices,
                     std::uint64_t faces)
    : SplitMesh(other.width_, memory) {
  reserve(vertices, faces);
  words_.assign(other.words_.begin(), other.words_.end());
  face_.assign(other.face_.begin(), other.face_.end());
  first_.assign(other.first_.begin(), other.first_.end());
}

void SplitMesh::reserve(std::uint64_t vertices, std::uint64_t faces) {
  words_.reserve(vertices * width_);
  first_.reserve(vertices);
  face_.reserve(faces);
}

void SplitMesh::add_vertex(std::span<const std::uint32_t> words) {
  words_.insert(words_.end(), words.begin(), words.end());
  first_.push_back(no_number);
}

void SplitMesh::add_face(const FaceVertices& face) {
  const std::uint32_t corner = 3 * faces();
  face_.push_back({face, {first_[face[0]], first_[face[1]], first_[face[2]]}});
  for (std::uint32_t i = 0; i < 3; ++i) first_[face[i]] = corner + i;
}

void SplitMesh::link(std::uint32_t corner, std::uint32_t v) {
  next(corner) = first_[v];
  first_[v] = corner;
}

void SplitMesh::unlink(std::uint32_t corner, std::uint32_t v) {
  const std::uint32_t behind = next(corner);
  if (first_[v] == corner) {
    first_[v] = behind;
  } else {
    const std::uint32_t previous = before(corner, v);
    next(previous) = behind;
    if (behind < before_.size()) before_[behind] = previous;
  }
  next(corner) = no_number;
}

// Without a branch: each is as likely to move as to stay.
void SplitMesh::share_out(std::span<const Split::Corner> around, std::uint32_t anchor,
                          std::uint32_t other) {
  const std::array<std::uint32_t, 2> owner{anchor, other};
  std::array<std::uint32_t, 2> first{no_number, no_number};
  for (const auto& [corner, moves] : around) {
    Face& face = face_[corner / 3];
    face.vertices[corner % 3] = owner[moves];
    face.next[corner % 3] = first[moves];
    first[moves] = corner;
  }
  first_[anchor] = first[0];
  first_[other] = first[1];
}

std::uint32_t SplitMesh::before(std::uint32_t corner, std::uint32_t v) {
  std::uint32_t at = first_[v];
  for (std::size_t i = 0; i < most_ring_faces && at != no_number; ++i) {
    if (next(at) == corner) return at;
    at = next(at);
  }
  return before_far(corner, v);
}

// A corner is walked over once, or once more for each that came before it since: those further down
// are known.
std::uint32_t SplitMesh::before_far(std::uint32_t corner, std::uint32_t v) {
  if (before_.size() < 3 * std::size_t{faces()}) before_.resize(3 * face_.capacity(), no_number);
  std::uint32_t& found = before_[corner];
  if (found < 3 * faces() && next(found) == corner) return found;
  bool passed = false;
  for (std::uint32_t at = first_[v]; next(at) != no_number; at = next(at)) {
    std::uint32_t& known = before_[next(at)];
    if (passed && known == at) break;
    known = at;
    passed = passed || next(at) == corner;
  }
  return found;
}

void SplitMesh::hand_over(std::uint32_t corner, std::uint32_t from, std::uint32_t to) {
  unlink(corner, from);
  link(corner, to);
  face_[corner / 3].vertices[corner % 3] = to;
}

void SplitMesh::find_ring(std::uint32_t v, Ring& ring) const {
  ring.clear();
  for (std::uint32_t corner = first_[v]; corner != no_number && !ring.full();) {
    const Face& face = face_[corner / 3];
    const std::uint32_t i = corner % 3;
    ring.add({face.vertices[after[i]], face.vertices[after[i + 1]]}, corner);
    corner = face.next[i];
  }
}

// A walk around the vertex at the far end would be as good: the anchor may have very many faces.
std::uint32_t SplitMesh::corner_at(std::uint32_t v, const FarEdge& far) const {
  if (far[0] >= vertices() || far[1] >= vertices()) return no_number;
  std::uint32_t at_v = first_[v], at_far = first_[far[0]];
  while (at_v != no_number && at_far != no_number) {
    const FaceVertices& face = face_[at_v / 3].vertices;
    const std::uint32_t i = at_v % 3;
    if (face[(i + 1) % 3] == far[0] && face[(i + 2) % 3] == far[1]) return at_v;
    const FaceVertices& other = face_[at_far / 3].vertices;
    const std::uint32_t k = at_far % 3;
    if (other[(k + 1) % 3] == far[1] && other[(k + 2) % 3] == v) return at_far - k + (k + 2) % 3;
    at_v = face_[at_v / 3].next[i];
    at_far = face_[at_far / 3].next[k];
  }
  return no_number;
}

bool SplitMesh::find_moved(const Split& split) {
  handed_.assign(split.corners.begin(), split.corners.end());
  for (const std::uint32_t corner : handed_) unlink(corner, split.anchor);
  for (const FarEdge& far : split.moved) {
    const std::uint32_t corner = corner_at(split.anchor, far);
    if (corner == no_number) {
      for (const std::uint32_t back : handed_) link(back, split.anchor);
      return false;
    }
    unlink(corner, split.anchor);
    handed_.push_back(corner);
  }
  return true;
}

bool SplitMesh::apply(const Split& split) {
  const std::uint32_t first = vertices();
  if (split.anchor == no_number ? split.moves : split.anchor >= first) return false;
  if (split.words.size() != width_ * (std::size_t{split.new_vertices} + split.moves)) return false;
  const bool moves_faces = !split.moved.empty() || !split.corners.empty() || !split.around.empty();
  if (moves_faces && (split.anchor == no_number || split.new_vertices == 0)) return false;
  if (split.new_vertices >= no_number - first) return false;
  if (split.restored.size() > (no_number - 3) / 3 - faces()) return false;
  for (const FaceVertices& face : split.restored) {
    for (const std::uint32_t v : face) {
      if (v >= first + split.new_vertices) return false;
    }
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) return false;
  }
  if (!find_moved(split)) return false;
  std::span<const std::uint32_t> words = split.words;
  if (split.moves) {
    std::copy_n(words.begin(), width_,
                words_.begin() + static_cast<std::ptrdiff_t>(split.anchor * width_));
    words = words.subspan(width_);
  }
  for (std::uint32_t i = 0; i < split.new_vertices; ++i)
    add_vertex(words.subspan(i * width_, width_));
  if (!split.around.empty()) share_out(split.around, split.anchor, first);
  for (const std::uint32_t corner : handed_) {
    link(corner, first);
    face_[corner / 3].vertices[corner % 3] = first;
  }
  for (const FaceVertices& face : split.restored) add_face(face);
  return true;
}

SplitMesh::Undo SplitMesh::undo_of(const Split& split) const {
  Undo undo{split.anchor,
            split.new_vertices,
            static_cast<std::uint32_t>(split.restored.size()),
            split.moves,
            {}};
  if (split.moves) {
    const std::span<const std::uint32_t> before = words(split.anchor);
    undo.before.assign(before.begin(), before.end());
  }
  return undo;
}

void SplitMesh::take_back(const Undo& undo, Split& split) {
  split.clear();
  split.anchor = undo.anchor;
  split.moves = undo.moves;
  split.new_vertices = undo.new_vertices;
  for (std::uint32_t i = undo.restored; i-- > 0;) {
    const std::uint32_t f = faces() - 1;
    split.restored.push_back(face_[f].vertices);
    for (std::uint32_t k = 0; k < 3; ++k) unlink(3 * f + k, face_[f].vertices[k]);
    face_.pop_back();
  }
  std::reverse(split.restored.begin(), split.restored.end());
  const std::uint32_t first = vertices() - undo.new_vertices;
  if (undo.anchor != no_number && undo.new_vertices > 0) {
    while (first_[first] != no_number) {
      const std::uint32_t corner = first_[first];
      split.corners.push_back(corner);
      hand_over(corner, first, undo.anchor);
    }
  }
  if (undo.moves) {
    const std::span<const std::uint32_t> now = words(undo.anchor);
    split.words.assign(now.begin(), now.end());
    std::copy_n(undo.before.begin(), width_,
                words_.begin() + static_cast<std::ptrdiff_t>(undo.anchor * width_));
  }
  split.words.insert(split.words.end(),
                     words_.begin() + static_cast<std::ptrdiff_t>(first * width_), words_.end());
  first_.resize(first);
  words_.resize(first * width_);
}

}  // namespace winnow
