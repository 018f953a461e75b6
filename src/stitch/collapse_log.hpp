// What every tile has collapsed, and how costly: one cost for all tiles is found from it.
#pragma once

#include "decimate/collapser.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// Filled tile by tile, by one thread; after finish() read by any number.
class CollapseLog {
 public:
  struct Cost {
    double cost = 0;            // never falls within a tile
    std::uint32_t removed = 0;  // faces, by this collapse and all before it
    float error = 0;            // the largest so far, to float precision and never above it
  };

  // Bytes a collapse at the most: less where positions are floats.
  static constexpr std::uint64_t entry_size = sizeof(Collapse) + sizeof(Cost);

  CollapseLog(Job& job, std::uint64_t memory);

  // Of the next tile.
  void append(const std::vector<Collapse>& edges, const std::vector<Cost>& costs);
  void finish();

  // The fewest collapses, the cheapest of all tiles, that remove so many faces: how many of each
  // tile; all where all are not enough. Of equally cheap ones those of lower tiles come first.
  [[nodiscard]] std::vector<std::uint64_t> cut(std::uint64_t faces) const;

  // All collapses that cost no more than this: how many of each tile.
  [[nodiscard]] std::vector<std::uint64_t> up_to(double cost) const;

  // How many collapses of a tile there are.
  [[nodiscard]] std::uint64_t entries(std::size_t tile) const {
    return first_[tile + 1] - first_[tile];
  }

  // All collapses of each tile.
  [[nodiscard]] std::vector<std::uint64_t> all() const;

  // The cost that such a cut reaches.
  [[nodiscard]] double cost_of(std::uint64_t faces) const;

  // Faces that all collapses remove.
  [[nodiscard]] std::uint64_t removed() const;

  // The largest error of the first `count` collapses of a tile.
  [[nodiscard]] double error(std::size_t tile, std::uint64_t count) const;

  [[nodiscard]] std::vector<Collapse> edges(std::size_t tile, std::uint64_t count) const;
  [[nodiscard]] std::vector<Cost> costs(std::size_t tile) const;

 private:
  [[nodiscard]] std::size_t tiles() const { return first_.size() - 1; }
  [[nodiscard]] Cost at(std::uint64_t entry) const;
  // How many collapses of a tile are below the cost, or not above it; known to be in that range.
  struct Range {
    std::uint64_t least, most;
  };
  [[nodiscard]] std::uint64_t count(std::size_t tile, double cost, bool with_equal,
                                    Range among) const;
  [[nodiscard]] std::uint64_t count(std::size_t tile, double cost, bool with_equal) const {
    return count(tile, cost, with_equal, {0, entries(tile)});
  }
  [[nodiscard]] std::uint64_t removed_by(std::size_t tile, std::uint64_t count) const;

  // Of a tile in edges_.
  struct Edges {
    std::uint64_t begin = 0;  // a byte
    bool single = false;      // SingleCollapse each
  };

  Spool edges_, costs_;
  std::vector<Edges> edges_of_;
  std::vector<std::uint64_t> removed_in_class_;  // of costs: faces
  std::vector<std::uint64_t> first_{0};  // entry of each tile; behind the last how many there are
};

}  // namespace winnow
