#include "stitch/collapse_recorder.hpp"

#include <algorithm>

namespace winnow {

namespace {

FarEdge far_edge(const FaceVertices& face, VertexNumber v) {
  const auto at = static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
  return {face[(at + 1) % 3], face[(at + 2) % 3]};
}

bool includes(const std::vector<VertexNumber>& among, VertexNumber v) {
  return std::find(among.begin(), among.end(), v) != among.end();
}

}  // namespace

RecordedCollapse& CollapseRecorder::repeat(const Collapse& edge) {
  record_.clear();
  if (edge.of_piece()) {
    repeat_piece(edge);
  } else {
    repeat_edge(edge);
  }
  record_.ringed.split.new_vertices = static_cast<std::uint32_t>(record_.gone.size());
  return record_;
}

RecordedCollapse& CollapseRecorder::leave_out(VertexNumber v) {
  record_.clear();
  record_.gone.push_back(v);
  put_words(v, record_.ringed.split.words);
  record_.ringed.split.new_vertices = 1;
  return record_;
}

void CollapseRecorder::repeat_piece(const Collapse& edge) {
  Split& split = record_.ringed.split;
  piece_.find(mesh_, edge.kept);
  for (const FaceNumber f : piece_.faces) split.restored.push_back(mesh_.face(f));
  for (const VertexNumber v : piece_.vertices) put_words(v, split.words);
  record_.gone.assign(piece_.vertices.begin(), piece_.vertices.end());
  decimation_.repeat(edge);
}

void CollapseRecorder::gather_faces(VertexNumber v, std::vector<Face>& faces) {
  faces.clear();
  mesh_.for_each_face(v, [&](FaceNumber f) { faces.push_back({f, mesh_.face(f)}); });
}

void CollapseRecorder::repeat_edge(const Collapse& edge) {
  Split& split = record_.ringed.split;
  const bool movable = !mesh_.locked(edge.kept);
  kept_.clear();
  removed_.clear();
  if (movable) put_words(edge.kept, kept_);
  put_words(edge.removed, removed_);
  gather_faces(edge.removed, at_removed_);
  // Those of the kept end stay unless they may fall onto others, which none of a vertex with more
  // faces does.
  at_kept_.clear();
  if (free_topology_ && mesh_.degree(edge.kept) <= most_ring_faces)
    gather_faces(edge.kept, at_kept_);
  decimation_.repeat(edge);
  if (movable) values_.collapsed(edge);

  for (const Face& face : at_removed_) {
    if (mesh_.removed(face.number)) {
      split.restored.push_back(face.vertices);
    } else {
      split.moved.push_back(far_edge(face.vertices, edge.removed));
    }
  }
  for (const Face& face : at_kept_) {
    if (mesh_.removed(face.number) && !has(face.vertices, edge.removed))
      split.restored.push_back(face.vertices);
  }
  record_.gone.push_back(edge.removed);
  for (const FaceVertices& face : split.restored) {
    for (const VertexNumber v : face) {
      if (!includes(record_.gone, v) && is_gone(v)) record_.gone.push_back(v);
    }
  }
  if (!is_gone(edge.kept)) {
    split.anchor = edge.kept;
    split.moves = movable;
    if (movable) {
      split.words = kept_;
      put_words(edge.kept, record_.ringed.before);
      // Of a vertex that does not move other tiles may have faces.
      if (mesh_.degree(edge.kept) <= most_ring_faces) {
        mesh_.for_each_corner(edge.kept, [&](FaceNumber, VertexNumber w, VertexNumber x) {
          record_.ringed.ring.push_back({w, x});
        });
      }
    }
  }
  for (const VertexNumber v : record_.gone) {
    if (v == edge.removed || v == edge.kept) {
      const Words& words = v == edge.removed ? removed_ : kept_;
      split.words.insert(split.words.end(), words.begin(), words.end());
    } else {
      put_words(v, split.words);
    }
  }
}

}  // namespace winnow
