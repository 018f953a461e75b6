// Weighted means of attributes by key: of the corners in a cell, or of those at a welded vertex.
#pragma once

#include "base/attribute.hpp"
#include "base/morton.hpp"
#include "cluster/kernel/corner_kernel.hpp"
#include "io/job.hpp"
#include "read/face_batch.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

struct AttributeMemory {
  std::uint64_t table = 0;
  std::size_t table_parts = 16;

  // What one thread needs besides, and the least that `table` can be.
  static std::uint64_t per_thread(std::size_t attributes);
  static std::uint64_t smallest_table(std::size_t parts, std::size_t attributes);
  // Bytes of one entry.
  static std::uint64_t entry_size(std::size_t attributes);
};

// Means of the keys that were added, in ascending order.
class AttributeCursor {
 public:
  virtual ~AttributeCursor() = default;

  // Writes the means at `key`, which never falls from call to call. Where nothing finite was added
  // they are 0.
  virtual void find(CellKey key, std::span<double> means) = 0;
};

class AttributeMeans {
 public:
  enum class Keys { cells, numbers };
  static std::unique_ptr<AttributeMeans> make(Job& job, const CarriedAttributes& carried, Keys keys,
                                              const AttributeMemory& memory);
  virtual ~AttributeMeans() = default;

  // Both from any thread of the arena the job runs in. Keys are those of the cells of the corners:
  // the good faces of a batch, corner by corner, as the corner kernel weighs them.
  virtual void add(const FaceBatch& faces, const CornerSums& corners) = 0;

  // Keys are numbers: those of the corners of one face, each of which weighs 1.
  virtual void add(const FaceBatch& faces, std::size_t face,
                   const std::array<std::uint64_t, 3>& numbers) = 0;

  // Between batches, when no add() is running.
  [[nodiscard]] virtual bool wants_to_spill() const = 0;
  virtual void spill() = 0;

  // The last call; the cursor must go before this does.
  virtual std::unique_ptr<AttributeCursor> finish() = 0;
};

}  // namespace winnow
