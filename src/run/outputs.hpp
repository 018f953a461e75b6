// All that a run of simplify() makes: meshes, and a map for each where somebody asks for maps.
#pragma once

#include "run/map_sink.hpp"
#include "run/result_sink.hpp"

namespace winnow {

struct Outputs {
  ResultSinks meshes;
  MapSinks maps{};  // none, or as many as meshes
};

// All appear, or, where one cannot, none. Maps come first: a mesh has its map beside it.
void finish(const Outputs& outputs);

}  // namespace winnow
