// The mesh that refinement began with, asked for the faces near a place.
#pragma once

#include "base/box.hpp"
#include "decimate/unfold.hpp"
#include "io/recent_blocks.hpp"
#include "mesh/stored_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// Faces come in the order of their vertices' keys, so those that follow each other are close. Each
// block of them has a box, and so has each group of blocks, and each group of groups. So few faces
// are read for a place.
class ReferenceMesh {
 public:
  // From the lowest to the highest corner of a box.
  struct Extent {
    Point low, high;
  };

  // `mesh` must stay. Uses at most `memory` for the boxes of blocks, and scratch for the rest of
  // them.
  ReferenceMesh(Job& job, const StoredMesh& mesh, std::uint64_t memory);

  [[nodiscard]] const StoredMesh& mesh() const { return mesh_; }

  // For one thread. Gives no faces for a place if more than most_faces() might be near, and none
  // any more when it has looked at so many faces.
  class Reader final : public ReferenceSurface {
   public:
    Reader(const ReferenceMesh& reference, std::uint64_t most_looks);
    std::vector<Triangle> faces_near(const Box& box) override;

    static std::uint64_t most_faces();
    // Bytes in use at most, besides what it gives.
    static std::uint64_t memory();

   private:
    struct Block {
      std::uint64_t number = UINT64_MAX;
      std::vector<Triangle> faces;
    };
    const std::vector<Triangle>& block(std::uint64_t number);
    // Adds the faces near `place` that are below the boxes of a level from `first` on, as many as
    // are in one group. Level 0 has the blocks. False where there are too many.
    bool add_faces(std::size_t level, std::uint64_t first, const Extent& place,
                   std::size_t& looked_at, std::vector<Triangle>& found);

    const ReferenceMesh& reference_;
    VertexIndex::Reader vertices_;
    RecentBlocks boxes_;
    std::vector<Block> blocks_;  // each where its number says
    std::uint64_t looks_left_;
  };

 private:
  Job& job_;
  const StoredMesh& mesh_;
  Spool boxes_;  // of blocks
  Reservation reserved_;
  std::vector<std::vector<Extent>> levels_;  // of groups of blocks, of groups of those and so on
};

}  // namespace winnow
