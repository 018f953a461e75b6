// What tiles collapsed, kept in a checkpoint: a run that goes on repeats it, which is quickly done.
#pragma once

#include "io/checkpoint_directory.hpp"
#include "io/journal.hpp"
#include "stitch/collapse_log.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace winnow {

struct TriedTile {
  std::vector<Collapse> edges;
  std::vector<CollapseLog::Cost> costs;  // one an edge
  std::uint64_t frozen = 0;  // faces that cannot change because of the borders between tiles
  double reached = std::numeric_limits<double>::infinity();  // all that costs no more is in it

  void clear() {
    edges.clear();
    costs.clear();
    frozen = 0;
    reached = std::numeric_limits<double>::infinity();
  }
};

// Of one attempt in one round, the tiles in order.
class TriedTiles {
 public:
  // Without a checkpoint nothing is kept.
  TriedTiles(const CheckpointDirectory* checkpoint, std::uint64_t round, unsigned attempt);

  // The next tile that an earlier run had tried.
  bool next(TriedTile& tile);
  // After the last of those.
  void append(const TriedTile& tile);

 private:
  std::unique_ptr<Journal> journal_;
  std::vector<std::byte> record_;
};

}  // namespace winnow
