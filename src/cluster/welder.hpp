// The other way from faces to a mesh: nothing is clustered, only equal positions are welded.
#pragma once

#include "cluster/attribute_means.hpp"
#include "cluster/clusterer.hpp"
#include "read/mesh_reader.hpp"

namespace winnow {

struct WeldMemory {
  std::uint64_t lists = 0;     // for sorting, all threads together
  std::uint64_t vertices = 0;  // of the result, with what they carry
  std::uint64_t faces = 0;
  AttributeMemory attributes;  // while they are summed up
};

struct WeldSettings {
  CarriedAttributes attributes;
  bool single = false;      // positions are going to be rounded to float
  double* area = nullptr;   // where given: of the good faces
  Grid* lattice = nullptr;  // where given: that of the vertices' keys
};

struct WeldResult {
  StoredMesh mesh;
  ClusterCounts counts{};
  std::uint64_t fused = 0;       // pairs of opposite faces that left one face
  std::uint64_t flat_pairs = 0;  // those without area that left none
};

// Vertices in the order of their keys on a lattice over the box of most, those beside it as if at
// its sides, those of one key by position; -0 is 0. `available`: about how many faces there are.
// Reads the positions twice and then the faces. The mesh may have vertices that no face uses.
// Attributes at equal positions are averaged, those of each corner of a face alike: so a seam,
// where they differ, has their mean. Those of vertices that no face uses are 0.
//
// Faces of the same three vertices become one, in the sense of most of them. If as many stand in
// one sense as in the other, the first in the input decides, for all that are connected with it
// (agree_on_sides()). If they also have no area, all are dropped: then each of their edges keeps an
// even or odd number of faces.
WeldResult weld(Job& job, MeshReader& reader, const WeldSettings& settings, WeldMemory memory,
                std::uint64_t available);

}  // namespace winnow
