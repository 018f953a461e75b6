#include "decimate/tile_mesh.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace winnow {

void keep_single(std::vector<VertexNumber>& vertices) {
  std::sort(vertices.begin(), vertices.end());
  std::size_t count = 0;
  for (std::size_t i = 0; i < vertices.size();) {
    std::size_t end = i + 1;
    while (end < vertices.size() && vertices[end] == vertices[i]) ++end;
    if (end == i + 1) vertices[count++] = vertices[i];
    i = end;
  }
  vertices.resize(count);
}

TileMesh::TileMesh(std::vector<Point> positions, std::vector<FaceVertices> faces,
                   std::vector<std::uint8_t> locked, bool linked)
    : position_(std::move(positions)),
      face_(std::move(faces)),
      flags_(std::move(locked)),
      live_faces_(face_.size()) {
  if (linked) link();
}

void TileMesh::link() {
  if (linked()) return;
  first_.assign(position_.size(), no_number);
  degree_.assign(position_.size(), 0);
  link_.assign(3 * face_.size(), {});
  // From the back, so that every chain begins with the vertex's lowest face.
  for (FaceNumber f = face_count(); f-- > 0;) {
    if (removed(f)) continue;
    for (std::uint32_t i = 3; i-- > 0;) {
      const VertexNumber v = face_[f][i];
      const std::uint32_t corner = 4 * f + i;
      const std::uint32_t second = std::exchange(first_[v], corner);
      link_[place_of(corner)].next = second;
      if (second != no_number) link_[place_of(second)].previous = corner;
      ++degree_[v];
    }
  }
  for (VertexNumber v = 0; v < vertex_count(); ++v) update_hub(v, degree_[v]);
}

void TileMesh::replace_faces(std::span<const SurvivingFace> left) {
  first_.clear();
  for (FaceVertices& face : face_) face[0] = no_number;
  for (const SurvivingFace& face : left) face_[face.number] = face.vertices;
  live_faces_ = left.size();
}

std::uint64_t TileMesh::memory(std::uint64_t vertices, std::uint64_t faces) {
  return vertices * (sizeof(Point) + 1 + 3 * sizeof(std::uint32_t)) +
         faces * (sizeof(FaceVertices) + 3 * sizeof(Link));
}

void TileMesh::update_hub(VertexNumber v, std::uint32_t faces) {
  const bool many = faces > (hub(v) ? hub_no_more : most_faces_beside_hubs);
  const unsigned hub = many || (flags_[v] & fixed_hub) != 0 ? hub_now : 0U;
  hubs_ += (hub != 0) - (flags_[v] & hub_now) / hub_now;
  flags_[v] = static_cast<std::uint8_t>((flags_[v] & ~hub_now) | hub);
}

std::uint32_t TileMesh::new_marks(std::uint32_t count) {
  mark_.resize(position_.size());
  if (UINT32_MAX - last_mark_ < count) {
    std::fill(mark_.begin(), mark_.end(), 0);
    last_mark_ = 0;
  }
  last_mark_ += count;
  return last_mark_ - count + 1;
}

std::span<const VertexNumber> TileMesh::open_neighbours(VertexNumber v) {
  neighbours_.clear();
  for_each_corner(v, [&](FaceNumber, VertexNumber w, VertexNumber x) {
    neighbours_.insert(neighbours_.end(), {w, x});
  });
  keep_single(neighbours_);
  return neighbours_;
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

TileMesh::Meeting TileMesh::meeting_at_hub(VertexNumber a, std::span<const StarFace> faces_at_edge,
                                           VertexNumber b, std::span<const StarFace> faces_b) {
  const std::uint32_t met = new_marks(1);
  Meeting meeting;
  for (const StarFace& face : faces_at_edge) {
    const VertexNumber across = face.w == b ? face.x : face.w;
    ++meeting.faces;
    meeting.common += mark_[across] != met;
    mark_[across] = met;
  }
  if (meeting.common != meeting.faces) return meeting;
  const std::uint32_t apart = new_marks(1);
  for (const StarFace& face : faces_b) {
    for (const VertexNumber w : {face.w, face.x}) {
      if (mark_[w] == met || mark_[w] == apart) continue;
      if (unknown(w) || faces_at(w, a, 1) != 0) {
        ++meeting.common;
        return meeting;
      }
      mark_[w] = apart;
    }
    if (mark_[face.w] != met || mark_[face.x] != met) continue;
    if (unknown(face.w) && unknown(face.x)) {
      meeting.falls_together = true;
      return meeting;
    }
    for_each_face(unknown(face.w) ? face.x : face.w, [&](FaceNumber f) {
      meeting.falls_together |= has(face_[f], a) && has(face_[f], face.w) && has(face_[f], face.x);
    });
  }
  return meeting;
}

void TileMesh::unlink(VertexNumber v, std::uint32_t corner) {
  const auto [next, previous] = link_[place_of(corner)];
  (previous == no_number ? first_[v] : link_[place_of(previous)].next) = next;
  if (next != no_number) link_[place_of(next)].previous = previous;
  --degree_[v];
}

unsigned TileMesh::collapse(const Collapse& edge) {
  const auto [kept, removed, position] = edge;
  position_[kept] = position;
  steps_ += degree_[removed];
  unsigned gone = 0;
  // What is handed over goes in front of the chain of `kept`.
  std::uint32_t first = no_number;
  std::uint32_t last = no_number;
  for (std::uint32_t corner = first_[removed]; corner != no_number;) {
    const std::uint32_t following = next(corner);
    const FaceNumber f = face_of(corner);
    FaceVertices& face = face_[f];
    if (has(face, kept)) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const VertexNumber v = face[i];
        if (v == removed) continue;
        unlink(v, 4 * f + i);
        update_hub(v, degree_[v]);
      }
      face[0] = no_number;
      ++gone;
    } else {
      face[place_in_face(corner)] = kept;
      link_[place_of(corner)].previous = last;
      (last == no_number ? first : link_[place_of(last)].next) = corner;
      last = corner;
    }
    corner = following;
  }
  if (last != no_number) {
    const std::uint32_t rest = std::exchange(first_[kept], first);
    link_[place_of(last)].next = rest;
    if (rest != no_number) link_[place_of(rest)].previous = last;
  }
  degree_[kept] += degree_[removed] - gone;
  update_hub(kept, degree_[kept]);
  first_[removed] = no_number;
  degree_[removed] = 0;
  update_hub(removed, 0);
  live_faces_ -= gone;
  return gone;
}

void TileMesh::collapse_all(std::span<const Collapse> edges) {
  std::vector<VertexNumber> into(position_.size());
  for (VertexNumber v = 0; v < vertex_count(); ++v) into[v] = v;
  for (const Collapse& edge : edges) position_[edge.kept] = edge.position;
  // From the back: what is removed is not met any more.
  for (std::size_t i = edges.size(); i-- > 0;) into[edges[i].removed] = into[edges[i].kept];
  for (FaceVertices& face : face_) {
    if (face[0] == no_number) continue;
    for (VertexNumber& v : face) v = into[v];
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) continue;
    face[0] = no_number;
    --live_faces_;
  }
}

void TileMesh::remove_face(FaceNumber f) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    unlink(face_[f][i], 4 * f + i);
    update_hub(face_[f][i], degree_[face_[f][i]]);
  }
  face_[f][0] = no_number;
  --live_faces_;
}

unsigned TileMesh::remove_pairs(VertexNumber v, std::vector<FaceVertices>& gone) {
  struct Seen {
    VertexNumber low, high;
    bool back;
    FaceNumber face;
    bool operator<(const Seen& other) const {
      return std::tie(low, high, back, face) <
             std::tie(other.low, other.high, other.back, other.face);
    }
  };
  std::vector<Seen> seen;
  for_each_corner(v, [&](FaceNumber f, VertexNumber w, VertexNumber x) {
    seen.push_back({std::min(w, x), std::max(w, x), w > x, f});
  });
  std::sort(seen.begin(), seen.end());
  unsigned removed = 0;
  for (auto first = seen.begin(); first != seen.end();) {
    const auto end = std::find_if(first, seen.end(), [&](const Seen& face) {
      return face.low != first->low || face.high != first->high;
    });
    const auto backs = std::find_if(first, end, [](const Seen& face) { return face.back; });
    // The first of the more numerous sense stays, if there is one.
    const auto stays = backs - first > end - backs ? first : backs;
    const bool even = backs - first == end - backs;
    for (; first != end; ++first) {
      if (first == stays && !even) continue;
      gone.push_back(face_[first->face]);
      remove_face(first->face);
      ++removed;
    }
  }
  return removed;
}

unsigned TileMesh::remove(std::span<const VertexNumber> vertices,
                          std::span<const FaceNumber> faces) {
  for (const VertexNumber v : vertices) {
    first_[v] = no_number;
    degree_[v] = 0;
    update_hub(v, degree_[v]);
  }
  for (const FaceNumber f : faces) face_[f][0] = no_number;
  live_faces_ -= faces.size();
  return static_cast<unsigned>(faces.size());
}

}  // namespace winnow
