// What lies beside a collapse that is being made.
#pragma once

#include "decimate/collapser.hpp"
#include "decimate/edge_star.hpp"
#include "decimate/tile_mesh.hpp"

#include <vector>

namespace winnow {

// Around a hub, which has too many faces to walk, only what the collapse changes.
class BesideCollapse {
 public:
  explicit BesideCollapse(TileMesh& mesh) : mesh_(mesh) {}

  // Before the mesh changes.
  void begin(const Collapse& edge, const EdgeStar& star) {
    into_hub_ = mesh_.hub(edge.kept);
    handed_over_.clear();
    if (into_hub_) handed_over_.assign(star.faces().begin(), star.faces().end());
  }
  [[nodiscard]] bool into_hub() const { return into_hub_; }

  // each(end, other) for the edges of one face that the collapse changes, before it: all of them
  // are at an end. Of a hub, only those at a face that goes.
  template <typename Each>
  void for_each_open_before(const Collapse& edge, const EdgeStar& star, const Each& each) const {
    for (const VertexNumber w : mesh_.open_neighbours(edge.removed)) each(edge.removed, w);
    if (!into_hub_) {
      for (const VertexNumber w : mesh_.open_neighbours(edge.kept)) {
        if (w != edge.removed) each(edge.kept, w);
      }
      return;
    }
    for (const StarFace& face : star.of_kept()) {
      const VertexNumber across = face.w == edge.removed ? face.x : face.w;
      if (mesh_.faces_at(edge.kept, across, 2) == 1) each(edge.kept, across);
    }
  }

  // The same of those that it leaves.
  template <typename Each>
  void for_each_open_after(const Collapse& edge, const Each& each) const {
    if (into_hub_) {
      for_each_vertex(edge, [&](VertexNumber v) {
        if (mesh_.faces_at(edge.kept, v, 2) == 1) each(edge.kept, v);
      });
    } else {
      for (const VertexNumber w : mesh_.open_neighbours(edge.kept)) each(edge.kept, w);
    }
  }

  // Afterwards: what changed makes new offers, and the vertex that was kept offers best() at once.
  template <typename Best>
  void renew(const Collapse& edge, Offers& offers, const Best& best) const {
    for_each_vertex(edge, [&](VertexNumber v) { offers.make_stale(v); });
    if (into_hub_) {
      // It may be one no more.
      offers.make_stale(edge.kept);
    } else {
      offers.set(edge.kept, best());
    }
  }

 private:
  template <typename Each>
  void for_each_vertex(const Collapse& edge, const Each& each) const {
    if (!into_hub_) {
      for (const VertexNumber w : mesh_.neighbours(edge.kept)) each(w);
      return;
    }
    mesh_.mark_anew();
    mesh_.mark(edge.kept);
    mesh_.mark(edge.removed);
    for (const StarFace& face : handed_over_) {
      for (const VertexNumber v : {face.w, face.x}) {
        if (mesh_.mark(v)) each(v);
      }
    }
  }

  TileMesh& mesh_;
  bool into_hub_ = false;
  std::vector<StarFace> handed_over_;  // to a hub
};

}  // namespace winnow
