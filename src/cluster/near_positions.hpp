// Which positions are so near to others that they move there.
#pragma once

#include "base/hash.hpp"
#include "cluster/grid.hpp"
#include "cluster/weld_lattice.hpp"
#include "io/job.hpp"
#include "io/spool_records.hpp"
#include "mesh/vertex_index.hpp"
#include "read/mesh_reader.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace winnow {

// How the budget is divided here.
struct NearWeldMemory {
  std::uint64_t sorting = 0;    // while vertices are linked
  std::uint64_t links = 0;      // likewise
  std::uint64_t positions = 0;  // likewise
  std::uint64_t moved = 0;      // positions that have moved; kept for as long as the reader

  // What one thread needs besides.
  static std::uint64_t per_thread();
};

// The most scratch that this takes of so many faces, in bytes.
std::uint64_t near_weld_scratch(std::uint64_t faces);

// The positions that moved, by their own, and where they moved to.
struct MovedPositions {
  std::unique_ptr<VertexIndex> from;
  std::unique_ptr<Spool> to;  // a Point each

  [[nodiscard]] std::uint64_t size() const { return from == nullptr ? 0 : from->size(); }
};

// For one thread.
class MovedFinder {
 public:
  MovedFinder(const MovedPositions& moved, const Grid& grid)
      : grid_(grid),
        from_(*moved.from),
        to_(*moved.to, sizeof(Point)),
        recent_(std::size_t{1} << bits, {Point{NAN, NAN, NAN}, {}}) {}

  // Where a position stands now.
  const Point& find(const Point& stored) {
    const Point p = without_minus_zero(stored);
    Found& recent = recent_[quick_hash(mixed_bits(p)) >> (64 - bits)];
    if (recent.position == p) return recent.target;
    if (!finite(p)) return stored;
    const std::uint64_t number = from_.find(key_of(grid_, p), p);
    recent = {p, number == VertexIndex::Reader::absent ? p : to_.at<Point>(number)};
    return recent.target;
  }

 private:
  struct Found {
    Point position, target;
  };
  static constexpr unsigned bits = 11;

  const Grid& grid_;
  VertexIndex::Reader from_;
  RecentBlocks to_;
  std::vector<Found> recent_;
};

// Reads all faces of `reader` once; their positions are keyed by `grid`.
MovedPositions find_moved(Job& job, MeshReader& reader, const Grid& grid, double distance,
                          const NearWeldMemory& memory);

}  // namespace winnow
