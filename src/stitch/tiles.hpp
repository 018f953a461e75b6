// A mesh cut into tiles, and threads that work on several at once.
#pragma once

#include "base/parallel.hpp"
#include "stitch/refine_settings.hpp"
#include "stitch/tile.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace winnow {

class Tiles {
 public:
  // `whole` and `settings` must stay.
  Tiles(Job& job, const StoredMesh& whole, const RefineSettings& settings,
        const RefineMemory& memory);

  [[nodiscard]] Job& job() const { return job_; }
  [[nodiscard]] const RefineSettings& settings() const { return settings_; }
  [[nodiscard]] const RefineMemory& memory() const { return memory_; }
  [[nodiscard]] const StoredMesh& whole() const { return whole_; }
  [[nodiscard]] std::uint64_t faces() const { return whole_.face_count; }
  [[nodiscard]] std::size_t count() const { return cut_.tiling.tiles(); }
  [[nodiscard]] const Tiling& tiling() const { return cut_.tiling; }
  [[nodiscard]] const IncomingFaces& incoming() const { return cut_.incoming; }

  [[nodiscard]] Tile load(std::size_t number, const TileParts& parts) const {
    Tile tile = load_tile(whole_, cut_.tiling, cut_.incoming, number, parts);
    if (parts.state_size > 0 && settings_.decimation.sequence)
      load_state_of_others(tile, *whole_.state, parts.state_size);
    return tile;
  }

  // Tiles from `first` on in order, several at once while their memory lasts: work(tile number,
  // item) on any thread, finish(tile number, item) in order. While a tile takes long, results of
  // others behind it wait, so that no thread has to.
  template <typename Item, typename Work, typename Finish>
  void for_each(std::size_t first, const Work& work, const Finish& finish) const {
    const AtOnce at_once = reserve();
    std::size_t next = first;
    pipeline<std::pair<std::size_t, Item>>(
        at_once.tiles,
        [&](auto& item) {
          item.first = next++;
          return item.first < count();
        },
        [&](auto& item) { work(item.first, item.second); },
        [&](auto& item) { finish(item.first, item.second); });
  }

 private:
  struct Cut {
    Tiling tiling;
    IncomingFaces incoming;
  };
  // Tiles that are worked on or wait, with their memory.
  struct AtOnce {
    std::uint64_t tiles = 0;
    Reservation working, waiting;
  };

  [[nodiscard]] Cut cut() const;
  [[nodiscard]] AtOnce reserve() const;

  Job& job_;
  const StoredMesh& whole_;
  const RefineSettings& settings_;
  RefineMemory memory_;
  Cut cut_;
};

// Counts of one tile, told to all in steps: threads would get into each other's way at every
// collapse.
class TileProgress {
 public:
  explicit TileProgress(ProgressMeter& progress) : progress_(progress) {}
  void add(std::uint64_t faces) {
    pending_ += faces;
    if (pending_ >= 2048) progress_.advance(std::exchange(pending_, 0));
  }

 private:
  ProgressMeter& progress_;
  std::uint64_t pending_ = 0;
};

}  // namespace winnow
