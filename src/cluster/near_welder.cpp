#include "cluster/near_welder.hpp"

#include "base/hash.hpp"
#include "base/memory_shares.hpp"
#include "cluster/components.hpp"
#include "cluster/near_links.hpp"
#include "cluster/resolution.hpp"
#include "cluster/weld_lattice.hpp"
#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"
#include "mesh/vertex_index.hpp"
#include "read/for_each_batch.hpp"
#include "read/good_faces.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

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

// The positions that moved, by their own, and where they moved to.
struct Moved {
  std::unique_ptr<VertexIndex> from;
  std::unique_ptr<Spool> to;  // a Point each

  [[nodiscard]] std::uint64_t size() const { return from == nullptr ? 0 : from->size(); }
};

// For one thread.
class MovedFinder {
 public:
  MovedFinder(const Moved& moved, const Grid& grid)
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

class NearWeld {
 public:
  NearWeld(Job& job, double distance, const NearWeldMemory& memory)
      : job_(job), distance_(distance), memory_(memory), positions_(job, memory.positions) {}

  Moved run(MeshReader& reader, const Grid& grid) {
    gather(reader, grid);
    Components components(job_, memory_.links);
    link(components);
    Moved moved = collect(components);
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
  Moved collect(Components& components) {
    const std::uint64_t count = record_count<KeyedPosition>(positions_);
    job_.progress.begin("join vertices", count, "vertices");
    SortedRecords<Move> moves(job_, memory_.sorting);
    {
      Numbered positions(job_, positions_);
      components.finish([&](std::uint64_t first, std::uint64_t other) {
        moves.add({other, positions.at(first).position});
      });
    }
    Moved moved;
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

class MovingReader final : public NearWeldedReader {
 public:
  MovingReader(Job& job, std::unique_ptr<MeshReader> reader, double distance,
               const NearWeldMemory& memory)
      : reader_(std::move(reader)),
        finders_(job.threads, [this] { return std::make_unique<MovedFinder>(moved_, grid_); }) {
    const InputFacts& facts = reader_->facts();
    facts_ = facts;
    facts_.faces.reset();  // how many are left shows when they are read
    first_ = reader_->first_finite_position();
    const Box box =
        measure_box_of_most(job, *reader_, facts.vertices.value_or(facts.faces.value_or(0)));
    if (box.empty) return;
    grid_ = lattice_over(box);
    moved_ = NearWeld(job, distance, memory).run(*reader_, grid_);
  }

  [[nodiscard]] std::uint64_t merged() const override { return moved_.size(); }
  [[nodiscard]] std::uint64_t collapsed() const override { return collapsed_; }

  void begin_positions(PassCorners corners) override { reader_->begin_positions(corners); }
  bool next_positions(RawBatch& batch) override { return reader_->next_positions(batch); }
  void decode_positions(const RawBatch& batch, FaceBatch& slice,
                        const PositionSink& sink) const override {
    if (moved_.size() == 0) return reader_->decode_positions(batch, slice, sink);
    std::array<std::array<double, FaceBatch::capacity>, 3> welded;
    MovedFinder& finder = finders_.local();
    reader_->decode_positions(batch, slice, [&](const PositionView& view) {
      for (std::size_t i = 0; i < view.count; ++i) {
        const Point p = finder.find({view.axis[0][i], view.axis[1][i], view.axis[2][i]});
        for (std::size_t axis = 0; axis < 3; ++axis) welded[axis][i] = p[axis];
      }
      sink({{welded[0].data(), welded[1].data(), welded[2].data()},
            view.count,
            view.first,
            view.corner});
    });
  }

  void begin_faces() override {
    collapsed_ = 0;
    reader_->begin_faces();
  }
  bool next_faces(RawBatch& batch) override { return reader_->next_faces(batch); }
  void decode_faces(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) const override {
    if (moved_.size() == 0) return reader_->decode_faces(batch, slice, sink);
    MovedFinder& finder = finders_.local();
    reader_->decode_faces(batch, slice, [&](const FaceBatch& /*slice*/) {
      const auto status = slice.status;
      const bool all_good = slice.all_good;
      const bool single = slice.single;
      for (std::size_t i = 0; i < slice.count; ++i) {
        if (slice.status[i] == FaceStatus::good) move_corners(finder, slice, i);
      }
      sink(slice);
      // The reader may not set them again for every slice.
      slice.status = status;
      slice.all_good = all_good;
      slice.single = single;
    });
  }

  bool next_part() override { return reader_->next_part(); }
  std::optional<std::array<double, 3>> first_finite_position() override { return first_; }
  std::vector<AttributeRange> attribute_ranges() override { return reader_->attribute_ranges(); }
  void release_memory() override { reader_->release_memory(); }
  void check_whole() const override { reader_->check_whole(); }
  [[nodiscard]] std::uint64_t bytes() const override { return reader_->bytes(); }
  [[nodiscard]] const std::string& name() const override { return reader_->name(); }

 private:
  static void to_doubles(FaceBatch& slice) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& floats = slice.single_position[corner][axis];
        std::copy_n(floats.begin(), slice.count, slice.position[corner][axis].begin());
      }
    }
    slice.single = false;
  }

  void move_corners(MovedFinder& finder, FaceBatch& slice, std::size_t face) const {
    const bool repeated = slice.repeats_a_corner(face);
    bool moved = false;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Point stored = slice.corner(corner, face);
      const Point target = finder.find(stored);
      if (!finite(stored) || target == stored) continue;
      moved = true;
      // That of another input may be of doubles.
      if (slice.single) to_doubles(slice);
      for (std::size_t axis = 0; axis < 3; ++axis)
        slice.position[corner][axis][face] = target[axis];
    }
    if (!moved || repeated || !slice.repeats_a_corner(face)) return;
    slice.status[face] = FaceStatus::cropped;
    slice.all_good = false;
    ++collapsed_;
  }

  std::unique_ptr<MeshReader> reader_;
  std::optional<std::array<double, 3>> first_;
  Grid grid_;
  Moved moved_;
  mutable PerSlot<MovedFinder> finders_;
  mutable std::atomic<std::uint64_t> collapsed_{0};
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

std::unique_ptr<NearWeldedReader> weld_near(Job& job, std::unique_ptr<MeshReader> reader,
                                            double distance, const NearWeldMemory& memory) {
  return std::make_unique<MovingReader>(job, std::move(reader), distance, memory);
}

}  // namespace winnow
