// Faces between cells, before the same three cells become one: what a closed surface stays.
#include "cluster/face_list.hpp"
#include "support/clustering.hpp"

#include <map>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

using Edge = std::pair<CellKey, CellKey>;

std::vector<CellFace> cell_faces(const std::vector<Triangle>& faces, const Grid& grid,
                                 std::uint64_t memory = std::uint64_t{8} << 20) {
  TestJob here;
  SortedRuns<CellFace> runs(here.job);
  FaceList list(here.job, memory, runs);
  for (const Triangle& face : faces) {
    const CellKey a = key_of(grid, face[0]);
    const CellKey b = key_of(grid, face[1]);
    const CellKey c = key_of(grid, face[2]);
    if (a != b && b != c && a != c) list.add(cell_face(a, b, c));
  }
  list.sort();
  std::vector<std::unique_ptr<RecordCursor<CellFace>>> sources;
  list.finish(sources);
  runs.add_cursors(sources);
  MergedCursor<CellFace> merged(std::move(sources));
  std::vector<CellFace> out;
  for (CellFace face; merged.next(face);) out.push_back(face);
  return out;
}

// For each edge between two cells: faces at it, and how often they run up its keys less how often
// down.
struct Use {
  std::uint64_t faces = 0;
  std::int64_t net = 0;
};

std::map<Edge, Use> edges_of(const std::vector<CellFace>& faces) {
  std::map<Edge, Use> edges;
  for (const CellFace& face : faces) {
    const auto& [a, b, c] = face.cell;
    const std::int64_t net = std::int64_t{face.along} - face.against;
    for (const auto& [edge, way] :
         {std::pair{Edge{a, b}, 1}, std::pair{Edge{b, c}, 1}, std::pair{Edge{a, c}, -1}}) {
      edges[edge].faces += std::uint64_t{face.along} + face.against;
      edges[edge].net += way * net;
    }
  }
  return edges;
}

}  // namespace

TEST_CASE("a closed surface leaves every edge with an even number of faces, as many each way") {
  for (const double cell : {1.5, 0.7, 0.3, 0.11, 0.05, 0.02}) {
    for (const auto& faces :
         {ball(40), ball(40, 0.3), cube(20), placed(ball(30, 0.2), 1, {5e6, 5e6, 0})}) {
      const Grid grid = Grid::over(box_of(faces), cell);
      const std::map<Edge, Use> edges = edges_of(cell_faces(faces, grid));
      CAPTURE(cell, faces.size());
      CHECK((edges.size() > 2 || cell > 1));
      std::size_t odd = 0;
      std::size_t unbalanced = 0;
      for (const auto& [edge, use] : edges) {
        odd += use.faces % 2;
        unbalanced += use.net == 0 ? 0 : 1;
      }
      CHECK(odd == 0);
      CHECK(unbalanced == 0);
    }
  }
}

TEST_CASE("a surface with a hole shows it") {
  std::vector<Triangle> faces = ball(40);
  faces.erase(faces.begin() + 1000);
  const std::map<Edge, Use> edges = edges_of(cell_faces(faces, Grid::over(box_of(faces), 0.02)));
  CHECK(std::count_if(edges.begin(), edges.end(),
                      [](const auto& edge) { return edge.second.faces % 2 == 1; }) == 3);
}

TEST_CASE(
    "faces are counted by their cells, whichever corner comes first, however they are turned") {
  Random random(460);
  // Few cells, many faces: repeats; little memory: runs in scratch.
  for (const std::uint64_t memory : {std::uint64_t{2} << 20, std::uint64_t{16} << 20}) {
    for (const std::uint64_t keys : {std::uint64_t{4}, std::uint64_t{30}, std::uint64_t{100'000}}) {
      TestJob here;
      SortedRuns<CellFace> runs(here.job);
      FaceList list(here.job, memory, runs);
      std::map<std::array<CellKey, 3>, std::pair<std::uint64_t, std::uint64_t>> right;
      for (int i = 0; i < 100'000; ++i) {
        std::array<CellKey, 3> cell{};
        for (CellKey& key : cell) key = random.below(keys);
        if (cell[0] == cell[1] || cell[1] == cell[2] || cell[0] == cell[2]) continue;
        list.add(cell_face(cell[0], cell[1], cell[2]));
        // Turned until the lowest comes first; then the others are either up or down.
        while (cell[0] > cell[1] || cell[0] > cell[2])
          std::rotate(cell.begin(), cell.begin() + 1, cell.end());
        const bool along = cell[1] < cell[2];
        if (!along) std::swap(cell[1], cell[2]);
        ++(along ? right[cell].first : right[cell].second);
      }
      list.sort();
      std::vector<std::unique_ptr<RecordCursor<CellFace>>> sources;
      list.finish(sources);
      runs.add_cursors(sources);
      MergedCursor<CellFace> merged(std::move(sources));
      std::map<std::array<CellKey, 3>, std::pair<std::uint64_t, std::uint64_t>> got;
      std::array<CellKey, 3> last{};
      for (CellFace face; merged.next(face);) {
        REQUIRE(last < face.cell);
        last = face.cell;
        got[face.cell] = {face.along, face.against};
      }
      CAPTURE(memory, keys);
      CHECK(got == right);
      CHECK((here.job.scratch.written() > 0) == (memory == 2 << 20 && keys == 100'000));
    }
  }
}

}  // namespace winnow
