#include "decimate/fan.hpp"

#include <algorithm>

namespace winnow {

// Goes on from the last neighbour as far as edges lead. False where it comes back to one but the first.
bool Fan::extend() {
  for (bool found = true; found && !closed_;) {
    found = false;
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      auto [a, b] = rim_[i];
      if (b == ring_.back()) std::swap(a, b);
      if (a != ring_.back()) continue;
      rim_[i] = rim_.back();
      rim_.pop_back();
      found = true;
      if (b == ring_.front()) {
        closed_ = true;
      } else if (std::find(ring_.begin(), ring_.end(), b) != ring_.end()) {
        return false;
      } else {
        ring_.push_back(b);
      }
      break;
    }
  }
  return true;
}

bool Fan::find(const TileMesh& mesh, VertexNumber v) {
  rim_.clear();
  ring_.clear();
  closed_ = false;
  mesh.for_each_face(v, [&](FaceNumber f) {
    if (rim_.size() > most_faces_of_fan) return;
    const FaceVertices& face = mesh.face(f);
    rim_.emplace_back(face[0] == v ? face[1] : face[0], face[2] == v ? face[1] : face[2]);
  });
  if (rim_.empty() || rim_.size() > most_faces_of_fan) return false;
  ring_.push_back(rim_.front().first);
  if (!extend()) return false;
  if (!closed_) {
    std::reverse(ring_.begin(), ring_.end());
    if (!extend()) return false;
  }
  if (!rim_.empty() || ring_.size() < (closed_ ? 3 : 2)) return false;
  seen_.resize(ring_.size());
  for (std::size_t i = 0; i < ring_.size(); ++i) seen_[i] = mesh.position(ring_[i]) - mesh.position(v);
  return true;
}

}  // namespace winnow
