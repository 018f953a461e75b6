// What a run tells of the surface that it is going to write.
#pragma once

#include <winnow/simplify_report.hpp>

#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace winnow {

struct CountedSurface {
  SurfaceEdges edges;
  // Connected ones, also by a vertex alone; absent where their count takes more than half of the
  // memory.
  std::optional<std::uint64_t> pieces;
};

struct ResultSurface : CountedSurface {
  bool closed = false;
  double area = 0;
};

// Counts edges exactly, by the numbers of their vertices, within `memory`: by lists, or where there
// is no room for these, by sorting, in scratch if need be. On a mesh whose faces come in the order
// of their lowest vertices, as all do but for `convert`, a third of the edges is listed or sorted.
ResultSurface measure_result(Job& job, const StoredMesh& mesh, std::uint64_t memory);

// The same without looking at positions.
CountedSurface count_surface(Job& job, const StoredMesh& mesh, std::uint64_t memory);

// Whether every side of a face meets one of the opposite direction, by the numbers of vertices: one
// pass.
bool is_closed(Job& job, const StoredMesh& mesh);

// The area alone. One pass.
double area_of(const Job& job, const StoredMesh& mesh);

// Notes where more than this part of the area went; the note begins with `of`.
void note_lost_area(Job& job, const std::string& of, double before, double after,
                    double part = 0.01);
// "12.3 %"
std::string percentage(double part);

}  // namespace winnow
