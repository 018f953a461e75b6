// The face that is nearest to a point, against a look at every face.
#include "base/closest_point.hpp"
#include "fit/face_index.hpp"
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/program.hpp"
#include "support/random.hpp"
#include "support/refining.hpp"
#include "support/shape_files.hpp"
#include "support/shapes.hpp"

#include <algorithm>
#include <cmath>
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

TEST_CASE("no face is the nearest where the boxes of too many are as near") {
  const Directory directory;
  const std::string crowd = directory.file("crowd.ply");
  write_file(crowd, ply_of(shapes::crowd(3'000, 300)));
  TestJob test;
  const StoredMesh mesh = welded(test.job, crowd);
  const std::vector<Triangle> all = triangles_of(mesh);
  // From the middle of all to places beside it.
  Box whole;
  for (const Triangle& t : all) whole.add(t[0]);
  std::vector<Point> points;
  for (int i = 0; i < 200; ++i)
    points.push_back(0.5 * whole.low + 0.5 * whole.high + i / 250.0 * (whole.high - whole.low));
  for (const std::uint64_t memory : {std::uint64_t{0}, std::uint64_t{64} << 20}) {
    const FaceIndex index(test.job, mesh, memory);
    FaceIndex::Reader reader(index);
    std::vector<FaceIndex::Nearest> found;
    reader.nearest(points, found);
    std::size_t left_out = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      double squared = std::numeric_limits<double>::infinity();
      std::vector<double> boxes;
      for (const Triangle& t : all) {
        const Point off = points[p] - closest_point(points[p], t);
        squared = std::min(squared, dot(off, off));
        double from_box = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
          const double away = std::max({low - points[p][axis], points[p][axis] - high, 0.0});
          from_box += away * away;
        }
        boxes.push_back(from_box);
      }
      const auto near = static_cast<std::size_t>(
          std::count_if(boxes.begin(), boxes.end(), [&](double box) { return box <= squared; }));
      const bool too_many = near > FaceIndex::Reader::most_boxes();
      left_out += too_many ? 1 : 0;
      INFO(p << ": " << near);
      CHECK(std::isinf(found[p].squared) == too_many);
      if (!too_many) CHECK(found[p].squared == squared);
    }
    CHECK(left_out > 20);
    CHECK(left_out < 180);
  }
}

}  // namespace winnow::test
