// The second half of the pipeline, as the options ask for it.
#pragma once

#include <winnow/simplify.hpp>

#include "cluster/clusterer.hpp"
#include "io/checkpoint_directory.hpp"
#include "io/job.hpp"
#include "run/clustering.hpp"
#include "stitch/refine.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace winnow {

// In eighths of what clustering left: four for tiles, one each for the mesh that goes into a round,
// for the one that comes out, for what was collapsed, and for sorting.
RefineMemory refine_memory(std::uint64_t left);

// How the run would divide a budget of `total`.
using PlanOf = std::function<MemoryPlan(std::uint64_t total)>;

// Messages of a tile that the budget has no room for then name one that has.
void expect_beside_tile(Job& job, const StoredMesh& whole, const Samples& samples,
                        const RefineSettings& settings, const PlanOf& plan);

// What is told of a level.
struct Refinement {
  LevelReport::Refinement refine;
  LevelReport::Fit fit;
  LevelReport::Lost lost;
  std::vector<StoppedBy> missed_by;
  std::uint64_t wanted = 0;                           // faces; 0 where an error says how many
  std::uint64_t rounds_before = 0, tiles_before = 0;  // done when it went on from a checkpoint
};

// Calls `take` with the mesh of each goal in order, the finest first. `doubles`: positions are
// going to be written as such. `map`: meshes tell where vertices went. `checkpoint`: null where
// nothing is kept. Throws Error(resources) where the budget has no room for a tile; it names one
// that has.
void refine_to_targets(Job& job, Clustered clustered, const SimplifyOptions& options, bool doubles,
                       bool map, const PlanOf& plan, CheckpointDirectory* checkpoint,
                       const std::function<void(const StoredMesh&, const Refinement&)>& take);

}  // namespace winnow
