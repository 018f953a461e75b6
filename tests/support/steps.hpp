// How much work refinement does, counted instead of timed.
#pragma once

#include "decimate/decimation.hpp"
#include "support/shapes.hpp"

#include <cstdint>
#include <vector>

namespace winnow::test {

// Corners that are visited while a shape is refined to so many faces, as one tile.
inline std::uint64_t steps_of_refining(const Shape& shape, std::uint64_t faces) {
  TileMesh mesh(shape.vertices, shape.faces, std::vector<std::uint8_t>(shape.vertices.size(), 0));
  Decimation::make(mesh, {}, {})->run({faces}, [](const DoneCollapse&) {});
  return mesh.steps();
}

}  // namespace winnow::test
