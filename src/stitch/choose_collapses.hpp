// Which collapses a round makes: the cheapest of all tiles, at one cost for all of them.
#pragma once

#include "stitch/collapse_log.hpp"
#include "stitch/tiles.hpp"
#include "stitch/tried_tiles.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace winnow {

// What rounds learn of costs.
struct KnownCosts {
  static constexpr double no_limit = std::numeric_limits<double>::infinity();

  double costliest = 0;  // collapse of the last round
  double highest_cost_allowed = no_limit;
};

// The first of a log's collapses in each tile.
struct ChosenCollapses {
  std::unique_ptr<CollapseLog> log;
  std::vector<std::uint64_t> counts;
};

// Of one round.
class CollapseChooser {
 public:
  // Goes on with `costs`. `checkpoint`: tiles that were tried are kept there, unless it is null, as
  // those of round `kept_as`.
  CollapseChooser(const Tiles& tiles, std::uint64_t round, KnownCosts& costs,
                  const CheckpointDirectory* checkpoint, std::uint64_t kept_as);

  // What the round is going to remove, for its progress: the first of many tiles tries more than it
  // keeps.
  [[nodiscard]] std::uint64_t faces_to_try() const;

  // All that there are.
  ChosenCollapses all();
  // Those that bring the mesh down to the wanted count, or as far as this round should go.
  ChosenCollapses cheapest();

  // Sets how costly a collapse may be where the count cannot be met: as costly as the costliest
  // would be that met it if nothing were kept. What is left then would cost more than the detail
  // that the count has no room for. False where it is known, or nothing is kept.
  bool find_highest_cost_allowed();

  // That a checkpoint held.
  [[nodiscard]] std::uint64_t tiles_before() const { return tiles_before_; }

 private:
  struct Tried {
    std::unique_ptr<CollapseLog> log;
    std::uint64_t frozen = 0;     // faces that cannot change because of the borders between tiles
    std::vector<double> reached;  // of each tile: all that costs no more was tried

    [[nodiscard]] bool complete_to(double cost) const;
  };

  // How far to try: no tile below this part of its share of the wanted faces, and up to this cost.
  struct TryLimits {
    double share, cost;
  };

  // Collapses what can be collapsed and writes it down; nothing is changed. `before`: another
  // attempt, whose tiles are taken over where they went as far.
  Tried try_all(const TryLimits& most, const Tried* before = nullptr);
  Tried try_all(const TryLimits& most, const DecimationSettings& settings, TriedTiles kept,
                const Tried* before);
  [[nodiscard]] std::uint64_t wanted_now(std::uint64_t frozen) const;
  [[nodiscard]] double deepest_share() const;
  [[nodiscard]] double headroom_of_estimates() const;
  [[nodiscard]] double left_by_tiles() const;

  const Tiles& tiles_;
  const RefineSettings& settings_;
  std::uint64_t round_;
  KnownCosts& costs_;
  const CheckpointDirectory* checkpoint_;
  std::uint64_t kept_as_;
  double sweeps_cost_;
  unsigned attempts_ = 0;
  std::uint64_t tiles_before_ = 0;
};

}  // namespace winnow
