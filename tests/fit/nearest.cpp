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
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i) {
    Point point = random.one_of(all)[0];
    const double off = random.one_of<double>({0, 1e-4, 0.05, 10});
    for (double& x : point) x += random.real(-off, off);
    points.push_back(point);
  }
  for (const std::uint64_t memory : {std::uint64_t{0}, std::uint64_t{64} << 20}) {
    const FaceIndex index(test.job, mesh, memory);
    CHECK(index.in_memory() == (memory > 0));
    CHECK(index.pages() == (memory > 0 ? 1 : 118));
    FaceIndex::Reader reader(index);
    for (const Point& point : points) {
      std::uint64_t want = 0;
      double least = std::numeric_limits<double>::infinity();
      for (std::uint64_t f = 0; f < all.size(); ++f) {
        const Point off = point - closest_point(point, all[f]);
        if (dot(off, off) >= least) continue;
        least = dot(off, off);
        want = f;
      }
      const FaceIndex::Nearest& found = reader.nearest(point);
      CHECK(found.face == want);
      CHECK(found.squared == least);
      CHECK(index.page_near(point) < index.pages());
    }
  }
}

}  // namespace winnow::test
