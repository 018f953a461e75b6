// Why the faces of a tile are left where the count was missed.
#pragma once

#include "decimate/decimation.hpp"
#include "stitch/refine_report.hpp"
#include "stitch/tile.hpp"

namespace winnow {

// Of the faces that belong to the tile.
BlockedFaces blocked_faces(Tile tile, const DecimationSettings& settings);

}  // namespace winnow
