// The second half of the pipeline: a clustered or welded mesh is made smaller by collapsing edges,
// tile by tile.
#pragma once

#include "decimate/decimation.hpp"
#include "io/checkpoint_directory.hpp"
#include "stitch/tile.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace winnow {

struct RefineSettings {
  DecimationSettings decimation;
  std::uint64_t faces = 0;  // wanted; 0: as few as there can be
  std::uint64_t tile_faces = std::uint64_t{1}
                             << 16;  // changes the result a little: never derived from memory
  std::uint64_t hub_faces = 512;  // a vertex with more faces across tiles is a hub: as tile_faces
  std::vector<Attribute> attributes{};  // that vertices carry
};

// What a tile of so many vertices and faces takes while it is worked on.
std::uint64_t tile_memory(const RefineSettings& settings, std::uint64_t vertices,
                          std::uint64_t faces);

struct RefineMemory {
  std::uint64_t tiles = 0;  // being worked on, all threads together
  std::uint64_t logs = 0;
  std::uint64_t mesh = 0;   // what comes out of a round
  std::uint64_t lists = 0;  // sorting
};

enum class StoppedBy { count, error, topology, boundaries, hubs, pieces };

// Faces that are left where the count was missed, by what keeps them: `topology` are those of no
// other kind.
struct BlockedFaces {
  std::uint64_t topology = 0;
  std::uint64_t boundaries = 0;  // at vertices that DecimationSettings::keep_boundaries keeps
  std::uint64_t hubs = 0;        // at hubs
  std::uint64_t pieces = 0;      // of small pieces that DecimationSettings::keep_pieces keeps

  void add(const BlockedFaces& more) {
    topology += more.topology;
    boundaries += more.boundaries;
    hubs += more.hubs;
    pieces += more.pieces;
  }
  // What keeps one face in eight or more, what keeps most of them first.
  [[nodiscard]] std::vector<StoppedBy> reasons() const;
};

struct RefineReport {
  std::uint64_t tiles = 0;  // of the first round
  std::uint64_t rounds = 0;
  std::uint64_t collapses = 0;
  double largest_error = 0;  // of a vertex from its planes, in the mean; model units
  StoppedBy stopped_by =
      StoppedBy::count;  // the first of blocked.reasons() where the count was missed
  BlockedFaces blocked;
  TopologyChanges changes;
  // What a checkpoint held: rounds that were done, and tiles of the next.
  std::uint64_t rounds_before = 0, tiles_before = 0;
};

// Never more faces than wanted, unless topology allows no fewer; at most one collapse less.
//
// With a checkpoint, every round and every tile that is done is kept in it, and at the end the
// result. Where it holds some already, `whole` has to be the mesh in it, and what is done is not
// done again; report.tiles_before says how much.
ClusteredMesh refine(Job& job, RefinedMesh whole, const RefineSettings& settings,
                     const RefineMemory& memory, RefineReport& report,
                     CheckpointDirectory* checkpoint = nullptr);

}  // namespace winnow
