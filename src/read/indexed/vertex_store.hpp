// Vertex positions by index: looked up in the mapped file, or kept in memory or scratch.
#pragma once

#include "base/memory_shares.hpp"
#include "base/vector.hpp"
#include "io/job.hpp"
#include "io/mapped_window.hpp"
#include "io/read_ahead.hpp"
#include "io/spool.hpp"
#include "read/face_batch.hpp"
#include "read/ply/header.hpp"

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// Where the coordinates stand in a record, and the attributes that are carried.
struct VertexLayout {
  std::size_t stride = 0;
  std::array<std::size_t, 3> offset{};
  std::array<PlyType, 3> type{};
  bool swapped = false;  // big-endian
  struct Number {
    std::size_t offset;
    NumberType type;
  };
  std::vector<Number> attributes{};
};

struct VertexRange {
  std::uint32_t lowest, highest;
};

// Filled once, by one thread; then looked up by many.
class VertexStore {
 public:
  // Resident pages of a mapping stay within `memory_limit`, and so does what is kept in memory.
  VertexStore(Job& job, std::uint64_t memory_limit) : job_(job), memory_limit_(memory_limit) {}
  ~VertexStore();
  VertexStore(const VertexStore&) = delete;
  VertexStore& operator=(const VertexStore&) = delete;

  // Either: records that stand in a file which can be mapped (`scratch`: its own, where it is such)
  // ...
  void map(const std::string& path, std::uint64_t offset, std::uint64_t count,
           const VertexLayout& layout, std::shared_ptr<const ScratchFile> scratch = nullptr);

  // ... or: records in memory that is another's and stays ...
  void look_in(const std::byte* records, std::uint64_t count, const VertexLayout& layout);

  // ... or: records handed over one stretch after the other. `attributes`: their types; then come
  // their numbers, as many a vertex.
  void begin_keeping(bool double_positions, std::span<const NumberType> attributes = {});
  void keep(std::span<const double> xyz, std::span<const double> attributes = {});
  void finish_keeping();

  // What is kept besides positions is given out no more.
  void drop_attributes() { layout_.attributes.clear(); }

  // What is kept in doubles is given out as floats from now on.
  void give_floats() { floats_ = true; }

  [[nodiscard]] std::uint64_t size() const { return count_; }

  // Positions and attributes of three vertices for each of `count` faces: `index[corner][face]`,
  // all in `range` and below size().
  void gather(const std::array<const std::uint32_t*, 3>& index, VertexRange range,
              std::size_t count, FaceBatch& out) const;

  // The same of records of another layout that somebody brought together: `index[corner][face]`
  // counts these.
  void gather_records(const std::byte* records, const VertexLayout& layout,
                      const std::array<const std::uint32_t*, 3>& index, std::size_t count,
                      FaceBatch& out) const;

  // Positions of single vertices, all below size(), into as many of `out`; also between passes.
  void look_up(std::span<const std::uint32_t> vertices, std::span<Point> out) const;

  // Positions in their order: `count` from `first` on, side by side into `out`.
  void read(std::uint64_t first, std::size_t count, const std::array<double*, 3>& out) const;

  // Appends the attributes of these, vertex by vertex.
  void read_attributes(std::uint64_t first, std::size_t count, std::vector<double>& out) const;

  // Calls each(record, count) with all records in their order, stretch by stretch.
  void for_each_stretch(const std::function<void(const std::byte*, std::size_t)>& each) const;

  // Where not all records may be resident at a time, what gather() does with faces that jump is
  // slow.
  [[nodiscard]] bool larger_than_memory() const { return watched_; }
  [[nodiscard]] std::uint64_t memory_limit() const { return memory_limit_; }
  [[nodiscard]] const VertexLayout& layout() const { return layout_; }
  // One batch alone may use a quarter; faces that jump farther are read one vertex at a time, which
  // is slow but touches no page.
  [[nodiscard]] bool too_wide(VertexRange range) const {
    return (range.highest - range.lowest + std::uint64_t{1}) * layout_.stride >
           share::reading::one_batch(memory_limit_);
  }
  static constexpr std::uint64_t resident_block = std::uint64_t{1} << 16;

  // Whole records from `first` on, read into `out` past the mapping; only where
  // larger_than_memory().
  void read_records(std::uint64_t first, std::size_t count, std::byte* out) const;

  // Between passes the pages of a mapping need not stay.
  void release_memory();
  void acquire_memory();

  void check_intact(const std::string& name) const;

 private:
  // Pages of the mapping that may be resident, in blocks of what the system maps at one fault.
  class ResidentBlocks {
   public:
    void reset(std::uint64_t bytes);
    // Calls first(begin, end) for each block that was not resident yet; returns the resident bytes.
    template <typename First>
    std::uint64_t touch(std::uint64_t begin, std::uint64_t end, const First& first);
    void clear();

   private:
    static constexpr unsigned block_bits = std::countr_zero(resident_block);
    std::vector<std::atomic<std::uint8_t>> touched_;
    std::atomic<std::uint64_t> resident_{0};
  };

  void open_mapping(const std::string& path, std::uint64_t offset, std::uint64_t bytes);
  void touch(std::uint64_t begin,
             std::uint64_t end) const;  // of the mapping; lets go of other pages
  void read_at(std::uint64_t offset, std::span<std::byte> bytes) const;  // of the mapped file
  // All of them, where there is no mapping.
  [[nodiscard]] const std::byte* in_memory() const {
    return given_ != nullptr ? given_ : kept_->data();
  }
  // Records that are read in order.
  const std::byte* stretch(std::uint64_t first, std::size_t count) const;
  [[nodiscard]] Point position_of(const std::byte* record) const;
  void gather_by_reading(const std::array<const std::uint32_t*, 3>& index, std::size_t count,
                         FaceBatch& out) const;

  Job& job_;
  std::uint64_t memory_limit_;
  std::uint64_t count_ = 0;
  VertexLayout layout_;
  bool floats_ = false;
  std::unique_ptr<Spool> kept_;
  const std::byte* given_ = nullptr;  // by look_in()
  std::shared_ptr<const ScratchFile> copied_;
  const ScratchFile* scratch_ = nullptr;  // where the mapped file is one
  std::vector<std::byte> packed_;         // keep()'s own
  std::unique_ptr<boost::interprocess::file_mapping> file_;
  std::unique_ptr<MappedWindow> window_;
  std::unique_ptr<ReadAhead> ahead_;  // of the mapped file
  int fd_ = -1;                       // of the mapped file, for lookups too scattered for a mapping
  std::uint64_t file_offset_ = 0;
  std::uint64_t resident_limit_ = 0;
  Reservation reservation_;  // for the mapping's resident pages
  bool watched_ = false;     // the mapping is larger than the limit
  mutable ResidentBlocks resident_;
  mutable std::mutex dropping_;
};

}  // namespace winnow
