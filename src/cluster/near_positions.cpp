#include "cluster/near_positions.hpp"

#include "base/memory_shares.hpp"
#include "cluster/components.hpp"
#include "cluster/near_links.hpp"
#include "cluster/resolution.hpp"
#include "io/sorted_records.hpp"
#include "read/for_each_batch.hpp"
#include "read/good_faces.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace winnow {

namespace {

// A position in one of the cells that it may have neighbours in. Cells that share a hash are taken
// for one, which costs time alone.
struct CellPosition {
  std::uint64_t cell;
  NumberedPoint point;

  static bool before(const CellPosition& a, const CellPosition& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.point.number < b.point.number;
  }
  static bool combine(CellPosition& /*into*/, const CellPosition& /*from*/) { return true; }
};

// Where a position moves to.
struct Move {
  std::uint64_t number;
  Point target;

  static bool before(const Move& a, const Move& b) { return a.number < b.number; }
  static bool combine(Move& /*into*/, const Move& /*from*/) { return false; }
};

// Cells for finding near positions. A position is put into each cell that it is nearer to than
// `reach` on every axis. Reach is more than half of the distance. So two near positions, whose
// reaches overlap, meet in a cell. Rounding preserves order, so this holds at any magnitude.
class Cells {
 public:
  explicit Cells(double distance)
      : reach_(0.75 * distance),
        edge_(std::min(16 * distance, std::numeric_limits<double>::max() / 4)) {}

  template <typename Visit>
  void for_each(const Point& p, const Visit& visit) const {
    std::array<std::array<double, 2>, 3> range{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      range[axis] = {cell(p[axis] - reach_), cell(p[axis] + reach_)};
    // At most two cells an axis. Where a cell's number has no successor, both ends are one.
    for_each_of(range[0], [&](double x) {
      for_each_of(range[1], [&](double y) {
        for_each_of(range[2], [&](double z) { visit(hash(x, y, z)); });
      });
    });
  }

 private:
  [[nodiscard]] double cell(double coordinate) const {
    constexpr double most = std::numeric_limits<double>::max();
    return std::floor(std::clamp(coordinate, -most, most) / edge_) + 0.0;
  }

  template <typename Visit>
  static void for_each_of(const std::array<double, 2>& range, const Visit& visit) {
    visit(range[0]);
    if (range[1] != range[0]) visit(range[1]);
  }

  static std::uint64_t hash(double x, double y, double z) {
    std::uint64_t value = 0;
    for (const double each : {x, y, z})
      value = mixed_hash(value ^ std::bit_cast<std::uint64_t>(each));
    return value;
  }

  double reach_, edge_;
};

class NearWeld {
 public:
  NearWeld(Job& job, double distance, const NearWeldMemory& memory)
      : job_(job), distance_(distance), memory_(memory), positions_(job, memory.positions) {}

  MovedPositions run(MeshReader& reader, const Grid& grid) {
    gather(reader, grid);
    Components components(job_, memory_.links);
    link(components);
    MovedPositions moved = collect(components);
    if (moved.size() == 0) return {};
    return moved;
  }

 private:
  // All positions of good faces, each once, in the order of their keys.
  void gather(MeshReader& reader, const Grid& grid) {
    job_.progress.begin("gather vertices", reader.facts().faces.value_or(0), "faces");
    ThreadedRecords<KeyedPosition> sorted(job_, memory_.sorting);
    PerSlot<RecentPositions> recent(job_.threads,
                                    [] { return std::make_unique<RecentPositions>(); });
    reader.begin_faces();
    const FaceSink sink = [&](const FaceBatch& batch) {
      SortedList<KeyedPosition>& list = sorted.local();
      RecentPositions& seen = recent.local();
      const GoodFaces good(batch);
      for (const NumberedFace& face : good.faces()) {
        for (const Point& corner : face.corner) {
          const Point p = without_minus_zero(corner);
          if (seen.add(p)) list.add({key_of(grid, p), p});
        }
      }
    };
    for_each_face_batch(job_, reader, sink, {});
    reader.release_memory();
    MergedCursor<KeyedPosition> merged = sorted.merged();
    Appender<KeyedPosition> append(job_, positions_);
    for (KeyedPosition position; merged.next(position);) append.add(position);
    append.flush();
    positions_.finish();
  }

  void link(Components& components) {
    const std::uint64_t count = record_count<KeyedPosition>(positions_);
    job_.progress.begin("find neighbours", 2 * count, "vertices");
    SortedRecords<CellPosition> sorted(job_, memory_.sorting);
    {
      const Cells cells(distance_);
      SpoolCursor<KeyedPosition> positions(job_, positions_);
      KeyedPosition at{};
      for (std::uint64_t number = 0; positions.next(at); ++number) {
        cells.for_each(at.position, [&](std::uint64_t cell) {
          sorted.add({cell, {number, at.position}});
        });
        if (number % chunk_records == 0)
          job_.progress.advance(std::min(chunk_records, count - number));
      }
    }
    MergedCursor<CellPosition> merged = sorted.merged();
    NearLinks near(distance_, job_.progress);
    const NearLinks::Link add = [&](std::uint64_t a, std::uint64_t b) { components.link(a, b); };
    std::vector<NumberedPoint> cell;
    Reservation room;
    std::uint64_t reserved = few_in_cell;
    std::uint64_t of = 0;
    std::uint64_t seen = 0;
    for (CellPosition next; merged.next(next);) {
      if (++seen % chunk_records == 0) job_.progress.advance(chunk_records);
      if (next.cell != of) {
        near.find(cell, add);
        cell.clear();
        of = next.cell;
      }
      if (cell.size() == reserved) {
        reserved *= 2;
        room.release();
        room = job_.budget.reserve(reserved * NearLinks::bytes_a_point,
                                   "vertices within one distance of `weld`");
        cell.reserve(reserved);
      }
      cell.push_back(next.point);
    }
    near.find(cell, add);
  }

  // Joins the members of components with their positions, in the order of numbers, twice.
  MovedPositions collect(Components& components) {
    const std::uint64_t count = record_count<KeyedPosition>(positions_);
    job_.progress.begin("join vertices", count, "vertices");
    SortedRecords<Move> moves(job_, memory_.sorting);
    {
      Numbered positions(job_, positions_);
      components.finish([&](std::uint64_t first, std::uint64_t other) {
        moves.add({other, positions.at(first).position});
      });
    }
    MovedPositions moved;
    moved.from = std::make_unique<VertexIndex>(job_, share::weld::moved_from(memory_.moved));
    moved.to = std::make_unique<Spool>(job_, share::weld::moved_to(memory_.moved));
    Appender<IndexedVertex, VertexIndex> from(job_, *moved.from);
    Appender<Point> to(job_, *moved.to);
    Numbered positions(job_, positions_);
    MergedCursor<Move> merged = moves.merged();
    for (Move move; merged.next(move);) {
      const KeyedPosition& at = positions.at(move.number);
      IndexedVertex vertex;
      vertex.key = at.key;
      vertex.position = at.position;
      from.add(vertex);
      to.add(move.target);
    }
    from.flush();
    to.flush();
    moved.from->finish();
    moved.to->finish();
    return moved;
  }

  // Positions by ascending numbers.
  class Numbered {
   public:
    Numbered(const Job& job, const Spool& positions) : cursor_(job, positions) {}

    const KeyedPosition& at(std::uint64_t number) {
      for (; next_ <= number; ++next_) cursor_.next(position_);
      return position_;
    }

   private:
    SpoolCursor<KeyedPosition> cursor_;
    std::uint64_t next_ = 0;
    KeyedPosition position_{};
  };

  // In one cell; what they take is part of what a thread needs.
  static constexpr std::uint64_t few_in_cell = 1024;

  Job& job_;
  double distance_;
  NearWeldMemory memory_;
  Spool positions_;  // KeyedPosition each, in order; a position's number is its place
};

}  // namespace

std::uint64_t NearWeldMemory::per_thread() {
  constexpr std::uint64_t blocks = RecentBlocks::most_blocks * RecentBlocks::block_bytes;
  return 2 * blocks + RecentPositions::bytes + mebibyte;
}

// Three positions a face, each in eight cells and linked in each, all sorted in runs of which two
// copies exist for a moment.
std::uint64_t near_weld_scratch(std::uint64_t faces) {
  const std::uint64_t cells = 8 * (sizeof(CellPosition) + 4 * sizeof(std::uint64_t));
  const std::uint64_t position = sizeof(KeyedPosition) + sizeof(Point) + sizeof(IndexedVertex);
  return faces * 3 * (2 * cells + position);
}

MovedPositions find_moved(Job& job, MeshReader& reader, const Grid& grid, double distance,
                          const NearWeldMemory& memory) {
  return NearWeld(job, distance, memory).run(reader, grid);
}

}  // namespace winnow
