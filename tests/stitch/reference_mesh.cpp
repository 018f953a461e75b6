// The faces near a place, against a look at every face.
#include "stitch/reference_mesh.hpp"

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/program.hpp"
#include "support/random.hpp"
#include "support/refining.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

bool meets(const Triangle& t, const Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
    if (!(low <= box.high[axis] && box.low[axis] <= high)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a reference mesh gives the faces near a place, whatever its memory", "[long]") {
  const Directory directory;
  const std::string scan = directory.file("scan.ply");
  // More than one group of groups of blocks.
  generate("scan", 1'200'000, scan);
  TestJob test;
  const StoredMesh mesh = welded(test.job, scan);
  const std::vector<Triangle> all = triangles_of(mesh);
  Random random(1);
  for (const std::uint64_t memory : {0, 1 << 20}) {
    const ReferenceMesh reference(test.job, mesh, memory);
    ReferenceMesh::Reader reader(reference, UINT64_MAX);
    for (int i = 0; i < 30; ++i) {
      Box box;
      box.add(random.one_of(all)[0]);
      const double size = random.real(0, 0.02);
      for (std::size_t axis = 0; axis < 3; ++axis) box.high[axis] += size;
      std::vector<Triangle> want;
      std::copy_if(all.begin(), all.end(), std::back_inserter(want),
                   [&](const Triangle& t) { return meets(t, box); });
      CAPTURE(memory, size, want.size());
      CHECK(reader.faces_near(box) == want);
    }
    Box everywhere;
    for (const Triangle& t : all) everywhere.add(t[0]);
    CHECK(reader.faces_near(everywhere).empty());  // too many
    ReferenceMesh::Reader tired(reference, 100'000);
    Box corner;
    corner.add(all[0][0]);
    int times = 0;
    while (!tired.faces_near(corner).empty() && times < 100'000) ++times;
    CHECK(times > 10);
    CHECK(times < 1000);
  }
}

}  // namespace winnow::test
