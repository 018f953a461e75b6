// Repeats collapses of a tile, and writes down what each takes away.
#pragma once

#include "decimate/carried_values.hpp"
#include "decimate/decimation.hpp"
#include "decimate/piece.hpp"
#include "decimate/tile_mesh.hpp"
#include "progressive/recorded_collapse.hpp"
#include "progressive/vertex_words.hpp"

#include <vector>

namespace winnow {

class CollapseRecorder {
 public:
  // `mesh` is linked. All must stay. `free_topology`: DecimationSettings::free_topology.
  CollapseRecorder(TileMesh& mesh, Decimation& decimation, CarriedValues& values,
                   const VertexWords& words, bool free_topology)
      : mesh_(mesh),
        decimation_(decimation),
        values_(values),
        words_(words),
        free_topology_(free_topology) {}

  // In numbers of the tile; good until the next call.
  RecordedCollapse& repeat(const Collapse& edge);
  // A vertex that has no face any more and that no collapse was told to take along.
  RecordedCollapse& leave_out(VertexNumber v);

 private:
  struct Face {
    FaceNumber number;
    FaceVertices vertices;
  };

  void repeat_piece(const Collapse& edge);
  void repeat_edge(const Collapse& edge);
  void gather_faces(VertexNumber v, std::vector<Face>& faces);
  // The vertex has no face left.
  [[nodiscard]] bool is_gone(VertexNumber v) const {
    return !mesh_.has_faces(v) && !mesh_.locked(v);
  }
  void put_words(VertexNumber v, Words& out) const {
    words_.put(mesh_.position(v), values_.of(v), out);
  }

  TileMesh& mesh_;
  Decimation& decimation_;
  CarriedValues& values_;
  const VertexWords& words_;
  bool free_topology_;
  Piece piece_;
  std::vector<Face> at_kept_, at_removed_;
  Words kept_, removed_;
  RecordedCollapse record_;
};

}  // namespace winnow
