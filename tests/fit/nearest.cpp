// The face that is nearest to a point, against a look at every face.
#include "base/closest_point.hpp"
#include "fit/face_index.hpp"
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/program.hpp"
#include "support/random.hpp"
#include "support/refining.hpp"

#include <limits>

#include <catch2/catch.hpp>

namespace winnow::test {

TEST_CASE("the nearest face of all is found, with few pages in memory or all") {
  const Directory directory;
  const std::string scan = directory.file("scan.ply");
  generate("scan", 60'000, scan);
  TestJob test;
  const StoredMesh mesh = welded(test.job, scan);
  const std::vector<Triangle> all = triangles_of(mesh);
  Random random(1);
  // Alone, on corners and beside them; and many at one place, some on a side.
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i) {
    const Triangle& t = random.one_of(all);
    const double off = random.one_of<double>({0, 1e-4, 0.05, 10});
    const std::size_t together = random.one_of<std::size_t>({1, 5, 40});
    for (std::size_t k = 0; k < together; ++k) {
      const double part = k % 2 == 0 ? 0 : random.unit();
      Point point = t[0] + part * (t[1] - t[0]);
      for (double& x : point) x += k % 3 == 0 ? 0 : random.real(-off, off);
      points.push_back(point);
    }
  }
  points.push_back({1e4, 0, 0});
  std::vector<FaceIndex::Nearest> want;
  for (const Point& point : points) {
    FaceIndex::Nearest& nearest = want.emplace_back();
    nearest.squared = std::numeric_limits<double>::infinity();
    for (std::uint64_t f = 0; f < all.size(); ++f) {
      const Point off = point - closest_point(point, all[f]);
      if (dot(off, off) >= nearest.squared) continue;
      nearest.squared = dot(off, off);
      nearest.face = f;
    }
  }
  for (const std::uint64_t memory : {std::uint64_t{0}, std::uint64_t{64} << 20}) {
    const FaceIndex index(test.job, mesh, memory);
    CHECK(index.in_memory() == (memory > 0));
    CHECK(index.pages() == (memory > 0 ? 4 : 118));
    FaceIndex::Reader reader(index);
    std::vector<FaceIndex::Nearest> found;
    reader.nearest(points, found);
    REQUIRE(found.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      INFO(i);
      CHECK(found[i].squared == want[i].squared);
      CHECK(found[i].face == want[i].face);
      CHECK(index.page_near(points[i]) < index.pages());
    }
  }
}

}  // namespace winnow::test
