// With --error the surface and its border stay within it, whatever the shape.
#include "support/refined_shape.hpp"

#include <algorithm>
#include <cmath>

namespace winnow::test {

namespace {

constexpr std::uint64_t samples = 50'000;
constexpr double border_allowance = 1.5;

void check_within(const RefinedShape& out, double error) {
  CAPTURE(error, out.input.faces.size(), out.output.faces.size());
  CHECK(out.compared.forward.rms <= error);
  CHECK(out.compared.backward.rms <= error);
  CHECK(out.compared.symmetric.rms <= error);
  const std::vector<Segment> before = border_of(out.input);
  const std::vector<Segment> after = border_of(out.output);
  REQUIRE(before.empty() == after.empty());
  constexpr std::size_t inner = 100;
  CHECK(border_distance(before, after, inner) <= border_allowance * error);
  CHECK(border_distance(after, before, inner) <= border_allowance * error);
}

}  // namespace

TEST_CASE("a disc keeps its rim within the error", "[shapes]") {
  struct Disc {
    std::size_t n, rings;
  };
  for (const Disc& disc : {Disc{12, 3}, Disc{60, 20}, Disc{200, 50}, Disc{400, 5}, Disc{1000, 2}}) {
    CAPTURE(disc.n, disc.rings);
    const Shape shape = shapes::disc(disc.n, disc.rings);
    for_each_pose([&](const Pose& pose) {
      for (const double error : {0.03, 0.003}) {
        const RefinedShape out = refine_shape(shape, pose, to_error(error), samples);
        check_within(out, error);
        // A polygon of so many corners is that near to the circle: no more than a few times as many
        // are needed.
        const double corners = std::numbers::pi / std::acos(1 - error);
        CHECK(static_cast<double>(out.output.faces.size()) < 4 * corners + 4);
      }
    });
  }
}

TEST_CASE("a plate thinner than the error stays closed and as large", "[shapes]") {
  for (const std::size_t n : {20, 60}) {
    CAPTURE(n);
    const Shape shape = shapes::plate(n);
    for_each_pose([&](const Pose& pose) {
      const RefinedShape out = refine_shape(shape, pose, to_relative_error(0.01), samples);
      CHECK(is_closed(out));
      check_within(out, 0.01 * box_of(out.input).diagonal());
      CHECK(area(out.output) == Approx(area(out.input)).epsilon(0.03));
    });
  }
}

TEST_CASE("a strip as wide as two errors keeps its length", "[shapes]") {
  for (const double width : {0.02, 0.1}) {
    for (const std::size_t n : {10, 100, 1000}) {
      CAPTURE(width, n);
      const Shape shape = shapes::strip(n, width);
      for_each_pose([&](const Pose& pose) {
        const RefinedShape out = refine_shape(shape, pose, to_error(0.01), samples);
        check_within(out, 0.01);
        CHECK(out.output.faces.size() <= 2);
        const Point along = turned(Point{1, 0, 0}, pose.angle);
        double low = 1;
        double high = 0;
        for (const Point& p : out.output.vertices) {
          low = std::min(low, dot(p, along));
          high = std::max(high, dot(p, along));
        }
        CHECK(std::abs(low) <= border_allowance * 0.01);
        CHECK(std::abs(high - 1) <= border_allowance * 0.01);
      });
    }
  }
}

TEST_CASE("hills keep their border within the error", "[shapes]") {
  const Shape shape = shapes::hills(60);
  for_each_pose([&](const Pose& pose) {
    for (const double error : {0.01, 0.002})
      check_within(refine_shape(shape, pose, to_error(error), samples), error);
  });
}

}  // namespace winnow::test
