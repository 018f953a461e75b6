#include "cluster/vertex_finders.hpp"

#include "cluster/weld_lattice.hpp"
#include "mesh/vertex_index.hpp"

namespace winnow {

namespace {

static_assert(static_cast<Destination>(VertexIndex::Reader::absent) == nowhere);

class WeldedFinder final : public VertexFinder {
 public:
  WeldedFinder(const VertexIndex& vertices, const Grid& lattice)
      : lattice_(lattice), vertices_(vertices) {}

  Destination find(const Point& position) override {
    const Point p = without_minus_zero(position);
    return static_cast<Destination>(vertices_.find(key_of(lattice_, p), p));
  }

 private:
  Grid lattice_;
  VertexIndex::Reader vertices_;
};

class ClusteredFinder final : public VertexFinder {
 public:
  ClusteredFinder(const VertexIndex& vertices, const Grid& grid, const SplitCells* split,
                  unsigned shift)
      : grid_(grid), split_(split), shift_(shift), vertices_(vertices) {}

  Destination find(const Point& position) override {
    return static_cast<Destination>(vertices_.number_of(key_at(position)));
  }

 private:
  [[nodiscard]] CellKey key_at(const Point& position) const {
    if (split_ != nullptr) return split_->name_at(grid_, position) >> shift_;
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<std::uint32_t>(grid_.cell_of(position[axis], axis));
    return morton_key(cell[0], cell[1], cell[2]);
  }

  Grid grid_;
  const SplitCells* split_;
  unsigned shift_;
  VertexIndex::Reader vertices_;
};

}  // namespace

MakeFinder welded_finder(const StoredMesh& mesh, const Grid& lattice) {
  return [&mesh, lattice] { return std::make_unique<WeldedFinder>(*mesh.vertices, lattice); };
}

MakeFinder clustered_finder(const StoredMesh& mesh, const Grid& grid, const SplitCells* split,
                            unsigned shift) {
  return [&mesh, grid, split, shift] {
    return std::make_unique<ClusteredFinder>(*mesh.vertices, grid, split, shift);
  };
}

}  // namespace winnow
