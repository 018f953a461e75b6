// The second half of the pipeline: a clustered or welded mesh is made smaller by collapsing edges,
// tile by tile.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "stitch/level_goal.hpp"
#include "stitch/reference_mesh.hpp"
#include "stitch/refine_report.hpp"
#include "stitch/refine_settings.hpp"
#include "stitch/tile.hpp"

#include <functional>
#include <memory>
#include <span>

namespace winnow {

struct Refined {
  StoredMesh mesh;
  RefineReport report;
  StoredMesh reference{};  // of a sequence: vertices and faces that the first round began with
};

// Never more faces than wanted, unless topology allows no fewer; at most one collapse less.
//
// With a checkpoint, every round and every tile that is done is kept in it, and at the end the
// result. Where it holds some already, `whole` has to be the mesh in it, and what is done is not
// done again; report.tiles_before says how much.
Refined refine(Job& job, StoredMesh whole, const RefineSettings& settings,
               const RefineMemory& memory, CheckpointDirectory* checkpoint = nullptr);

// The mesh of a level, lent, and what refining it told; the last one may be taken away.
using TakeLevel = std::function<void(StoredMesh& mesh, const RefineReport& report)>;

// Moves vertices of a level's mesh before it is unfolded and taken, and returns them as they were.
// `reference`: the mesh before the first round.
using MoveVertices =
    std::function<std::unique_ptr<VertexIndex>(StoredMesh& mesh, const ReferenceMesh& reference)>;

// The same for several goals, each coarser than the one before: the rounds of a level go on from
// the mesh that the level before has left, and the first level is what it would be alone. Calls
// `take` for each in order, after `move` where there is one. Levels that a checkpoint holds are
// taken from there.
void refine_levels(Job& job, StoredMesh whole, const RefineSettings& settings,
                   std::span<const LevelGoal> goals, const RefineMemory& memory,
                   CheckpointDirectory* checkpoint, const TakeLevel& take,
                   const MoveVertices& move = {});

}  // namespace winnow
