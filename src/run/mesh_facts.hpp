// What is told of the mesh that refinement begins with, in the manifest of a checkpoint and back.
#pragma once

#include "base/attribute.hpp"
#include "io/manifest.hpp"
#include "stitch/level_goal.hpp"

#include <vector>

namespace winnow {

struct MeshFacts {
  std::vector<LevelGoal> goals;
  std::vector<Attribute> attributes;
  bool normals = false, double_positions = false;  // of the input
};

void put(Manifest& manifest, const MeshFacts& facts);
[[nodiscard]] bool holds_facts(const Manifest& manifest);
MeshFacts facts_in(const Manifest& manifest);

}  // namespace winnow
