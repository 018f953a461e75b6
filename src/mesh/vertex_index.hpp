// The vertices of the result, by key and by number, in memory or in scratch.
#pragma once

#include "base/morton.hpp"
#include "base/pages.hpp"
#include "base/vector.hpp"
#include "io/recent_blocks.hpp"
#include "io/spool.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

struct IndexedVertex {
  CellKey key = 0;
  Point position{};
  std::array<float, 3> normal{};  // mean of unit normals: shorter than 1 where they disagree
  std::uint32_t unused = 0;
};
static_assert(sizeof(IndexedVertex) == 48);

// Filled in ascending order of keys by one thread; after finish() asked by any number, each through
// a Reader of its own.
class VertexIndex {
 public:
  VertexIndex(Job& job, std::uint64_t memory);
  // Finished already: of the records() of another.
  VertexIndex(Job& job, Spool records);

  void append(std::span<const IndexedVertex> vertices);
  void finish();

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const Spool& records() const { return records_; }

  static constexpr std::size_t block_vertices =
      RecentBlocks::records_a_block(sizeof(IndexedVertex));

  class Reader {
   public:
    explicit Reader(const VertexIndex& index);

    struct Found {
      std::uint64_t number;
      IndexedVertex vertex;
    };
    // `key` must be in the index.
    const Found& find(CellKey key);
    // Of the vertices with one key, in the order of their positions, that at this one; `absent` if
    // there is none.
    std::uint64_t find(CellKey key, const Point& position);
    static constexpr std::uint64_t absent = UINT64_MAX;
    // The number of the vertex with this key, in an index with one vertex a key; or `absent`.
    std::uint64_t number_of(CellKey key);
    IndexedVertex at(std::uint64_t number) { return blocks_.at<IndexedVertex>(number); }
    Point position(std::uint64_t number) {
      Point position;
      const std::span<const std::byte> record = blocks_.record(number);
      std::memcpy(&position, record.data() + offsetof(IndexedVertex, position), sizeof position);
      return position;
    }
    // The number of the first vertex whose key is not below `key`; size() where there is none.
    std::uint64_t lower_bound(CellKey key);

   private:
    static constexpr unsigned recent_bits = 9;

    Found search(CellKey key);
    std::span<const IndexedVertex> block(std::uint64_t number);

    const VertexIndex& index_;
    std::vector<Found>
        recent_;  // faces come in key order, so their vertices are asked for again soon
    RecentBlocks blocks_;
  };

 private:
  Job& job_;
  Spool records_;
  std::uint64_t size_ = 0;
  // First key of every block; and, for a quick start, where the keys of each range of keys begin.
  std::vector<CellKey> first_keys_;
  std::vector<std::uint32_t> range_start_;
  unsigned range_shift_ = 0;
  Reservation reservation_;
};

}  // namespace winnow
