// Which vertices of the input good faces have: a bit each, in memory for as many as there is room
// for, and sorted in scratch for the others.
#pragma once

#include "base/pages.hpp"
#include "io/job.hpp"
#include "io/recent_blocks.hpp"
#include "io/spool.hpp"
#include "read/mesh_reader.hpp"

#include <cstdint>
#include <optional>

namespace winnow {

class UsedVertices {
 public:
  // Reads all faces once. There are about so many `vertices`.
  UsedVertices(Job& job, MeshReader& faces, std::uint64_t vertices);

  // For one thread.
  class Reader {
   public:
    explicit Reader(const UsedVertices& used);
    bool has(std::uint64_t vertex);

   private:
    const UsedVertices& used_;
    std::optional<RecentBlocks> others_;
  };

 private:
  // A word has the bits of 64 vertices.
  [[nodiscard]] std::uint64_t words_in_memory() const {
    return bits_.size() / sizeof(std::uint64_t);
  }

  Pages bits_;
  std::optional<Spool> others_;  // the words behind those in memory
};

}  // namespace winnow
