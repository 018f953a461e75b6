// Only what lies in a box.
#pragma once

#include "base/box.hpp"
#include "read/mesh_reader.hpp"

namespace winnow {

// Faces with a corner outside of the box have the status `cropped`, and positions outside are no
// numbers. A corner on the box's side is inside.
std::unique_ptr<MeshReader> crop_to(const Box& box, std::unique_ptr<MeshReader> reader);

}  // namespace winnow
