// What the options of simplify() mean to the stages of the pipeline.
#pragma once

#include <winnow/simplify.hpp>

#include "read/mesh_reader.hpp"
#include "run/plan.hpp"

namespace winnow {

// Throws Error(usage) where options are out of range or contradict each other.
void check(const SimplifyOptions& options);

Refine cost_of(const SimplifyOptions& options);
// How often vertices are fitted to the original at the end.
unsigned fit_passes(const SimplifyOptions& options);
// Vertices that are near each other, not only equal ones.
bool welds(const SimplifyOptions& options);
// `map`: whether somebody asks where vertices went.
Access access_for(const SimplifyOptions& options, bool map);
CellNeeds needs_of(const SimplifyOptions& options, const AttributeSelection& choice = {});

}  // namespace winnow
