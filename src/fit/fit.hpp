// The last word on where vertices are: as near to the original as the faces of the result allow.
#pragma once

#include "fit/samples.hpp"
#include "mesh/stored_mesh.hpp"
#include "stitch/reference_mesh.hpp"
#include "stitch/refine_settings.hpp"

#include <cstdint>
#include <memory>

namespace winnow {

struct FitReport {
  std::uint64_t passes = 0;
  std::uint64_t samples = 0;
  std::uint64_t moved = 0;  // vertices, in all passes together
  double rms_before = 0;    // of the distances of samples from the result, in model units
  double rms_after = 0;     // along normals, where samples keep their places on the faces
};

struct FitSettings {
  unsigned passes = 1;      // at least one
  bool boundaries = false;  // vertices of boundaries and of edges with more faces move, too
};

// Moves the vertices of the mesh, and returns them as they were.
// `reference`: of the mesh before it was refined with these `settings` and this `memory`. Inside
// the job's arena.
std::unique_ptr<VertexIndex> fit(Job& job, StoredMesh& mesh, const Samples& samples,
                                 const FitSettings& how, const ReferenceMesh& reference,
                                 const RefineSettings& settings, const RefineMemory& memory,
                                 FitReport& report);

}  // namespace winnow
