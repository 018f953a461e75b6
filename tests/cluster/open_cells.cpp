// The cells that boundaries pass through, whatever the order and the senses of the faces.
#include "cluster/open_cells.hpp"

#include "io/arena.hpp"
#include "io/spool_records.hpp"
#include "support/job.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

CellKey key_at(const Grid& grid, const Point& p) {
  std::array<std::uint32_t, 3> cell{};
  for (std::size_t k = 0; k < 3; ++k) cell[k] = static_cast<std::uint32_t>(grid.cell_of(p[k], k));
  return morton_key(cell[0], cell[1], cell[2]);
}

Grid grid_over(const Shape& shape, double cell) {
  Box box;
  for (const Point& p : shape.vertices) box.add(p);
  return Grid::over(box, cell);
}

std::vector<CellKey> open_cells(const Shape& shape, const Grid& grid, std::uint64_t memory) {
  TestJob test;
  OpenCells cells(test.job, grid, false, memory);
  auto batch = std::make_unique<FaceBatch>();
  for (std::size_t first = 0; first < shape.faces.size(); first += batch->count) {
    batch->count = std::min(FaceBatch::capacity, shape.faces.size() - first);
    batch->status.fill(FaceStatus::good);
    for (std::size_t i = 0; i < batch->count; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < 3; ++k)
          batch->position[c][k][i] = shape.vertices[shape.faces[first + i][c]][k];
      }
    }
    in_arena(test.job, [&] {
      cells.add(*batch);
      return 0;
    });
  }
  return in_arena(test.job, [&] {
    const std::unique_ptr<Spool> keys = cells.finish();
    return read_records<CellKey>(*keys, 0, record_count<CellKey>(*keys));
  });
}

// By counting the faces at each edge.
std::vector<CellKey> by_counting(const Shape& shape, const Grid& grid) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces_at;
  for (const auto& face : shape.faces) {
    for (std::size_t i = 0; i < 3; ++i) ++faces_at[std::minmax(face[i], face[(i + 1) % 3])];
  }
  std::set<CellKey> open;
  for (const auto& [edge, faces] : faces_at) {
    if (faces % 2 == 0) continue;
    for (const std::uint32_t v : {edge.first, edge.second})
      open.insert(key_at(grid, shape.vertices[v]));
  }
  return {open.begin(), open.end()};
}

}  // namespace

TEST_CASE("the cells of boundaries are found in any order of faces") {
  Random random(4);
  for (const double cell : {0.02, 0.1, 0.4}) {
    Shape shape = shapes::hills(60);
    shape.faces.erase(shape.faces.begin() + 2000);  // a hole within a cell
    const Grid grid = grid_over(shape, cell);
    const std::vector<CellKey> right = by_counting(shape, grid);
    CHECK(open_cells(shape, grid, 1 << 20) == right);
    for (std::size_t i = shape.faces.size(); i > 1; --i)
      std::swap(shape.faces[i - 1], shape.faces[random.below(i)]);
    for (auto& face : shape.faces) {
      if (random.chance(0.5)) std::swap(face[0], face[1]);
    }
    CHECK(open_cells(shape, grid, 1 << 18) == right);
  }
}

TEST_CASE("a closed surface has no open cells") {
  const Shape shape = shapes::thin_shell(30, 0.01);
  CHECK(open_cells(shape, grid_over(shape, 0.05), 1 << 20).empty());
}

}  // namespace winnow::test
