// What the options of simplify() mean to the stations.
#pragma once

#include <winnow/simplify.hpp>

#include "read/mesh_reader.hpp"

namespace winnow {

// Throws Error(usage) where options are out of range or contradict each other.
void check(const SimplifyOptions& options);

Refine cost_of(const SimplifyOptions& options);
Access access_for(const SimplifyOptions& options);
bool sums_quadrics(const SimplifyOptions& options);

}  // namespace winnow
