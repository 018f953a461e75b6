// A plate full of holes that cannot become few faces: it keeps its shape, or it loses holes, as is
// asked for.
#include "support/refined_shape.hpp"

#include <cmath>
#include <map>

namespace winnow::test {

namespace {

// Closed, with n x n square tunnels from side to side; each cell of 3 x 3 is open in its middle and
// has `fine` squares a side.
Shape sieve(std::size_t n, std::size_t fine) {
  const std::size_t side = 3 * n * fine;
  const auto solid = [&](std::size_t i, std::size_t j) {
    return i < side && j < side && !((i / fine) % 3 == 1 && (j / fine) % 3 == 1);
  };
  Shape shape;
  std::map<std::array<std::size_t, 3>, std::uint32_t> numbers;
  const double step = 1 / static_cast<double>(3 * fine);
  const auto vertex = [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto [at, added] =
        numbers.emplace(std::array{i, j, k}, static_cast<std::uint32_t>(shape.vertices.size()));
    // Not flat, so that faces are worth something.
    const double x = step * static_cast<double>(i);
    const double y = step * static_cast<double>(j);
    if (added)
      shape.vertices.push_back(
          {x, y, 0.4 * static_cast<double>(k) + 0.1 * std::sin(x) * std::cos(y)});
    return at->second;
  };
  const auto square = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    shape.faces.push_back({a, b, c});
    shape.faces.push_back({a, c, d});
  };
  for (std::size_t i = 0; i < side; ++i) {
    for (std::size_t j = 0; j < side; ++j) {
      if (!solid(i, j)) continue;
      const auto at = [&](std::size_t di, std::size_t dj, std::size_t k) {
        return vertex(i + di, j + dj, k);
      };
      square(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
      square(at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0));
      if (!solid(i + 1, j)) square(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
      if (i == 0 || !solid(i - 1, j)) square(at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1));
      if (!solid(i, j + 1)) square(at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1));
      if (j == 0 || !solid(i, j - 1)) square(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
    }
  }
  return shape;
}

std::int64_t euler_of(const Shape& closed) {
  return static_cast<std::int64_t>(closed.vertices.size()) -
         static_cast<std::int64_t>(closed.faces.size() / 2);
}

}  // namespace

TEST_CASE("a sieve that cannot become few faces keeps its shape and says so", "[shapes]") {
  const std::size_t n = 6;
  const Shape shape = sieve(n, 3);
  const Pose pose{0.4, Numbers::floats};
  const RefinedShape out = refine_shape(shape, pose, to_count(150), 50'000);
  CHECK(is_closed(out));
  CHECK(euler_of(out.output) == euler_of(out.input));
  CHECK(euler_of(out.output) == 2 - 2 * static_cast<std::int64_t>(n * n));
  CHECK(out.report.target_met == false);
  CHECK(out.report.refine.stopped_by == StoppedBy::topology);
  CHECK(out.report.missed_by == std::vector{StoppedBy::topology});
  REQUIRE(out.report.notes.size() == 1);
  CHECK(out.report.notes[0].find("`topology` free") != std::string::npos);
  CHECK(out.report.lost.handles == 0);
  const double before = volume(out.input).value();
  CHECK(volume(out.output).value() == Approx(before).epsilon(0.2));
  // Four corners at either end of a tunnel.
  CHECK(out.output.faces.size() < 40 * n * n);

  SimplifyOptions options = to_count(150);
  options.topology = Topology::free;
  const RefinedShape free = refine_shape(shape, pose, options, 50'000);
  CHECK(free.output.faces.size() <= 150);
  CHECK(free.output.faces.size() >= 145);
  CHECK(free.report.target_met == true);
  CHECK(free.report.missed_by.empty());
  CHECK(free.report.lost.handles > 0);
  CHECK(free.report.lost.pieces == 0);
  CHECK(free.defects.duplicates + free.defects.degenerate + free.defects.boundary_edges == 0);
  // Stopped while collapses were at most twice as far off as the costliest of these.
  CHECK(out.compared.symmetric.rms < 2 * free.compared.symmetric.rms);
}

TEST_CASE("a sieve keeps or loses its holes by every cost", "[shapes]") {
  const std::size_t n = 5;
  const Shape shape = sieve(n, 3);
  SimplifyOptions options = to_count(120);
  options.refine = GENERATE(Refine::volume, Refine::importance);
  const RefinedShape out = refine_shape(shape, {}, options);
  CHECK(is_closed(out));
  CHECK(euler_of(out.output) == euler_of(out.input));
  CHECK(out.report.missed_by == std::vector{StoppedBy::topology});
  CHECK(volume(out.output).value() == Approx(volume(out.input).value()).epsilon(0.2));
  options.topology = Topology::free;
  const RefinedShape free = refine_shape(shape, {}, options);
  CHECK(free.output.faces.size() <= 120);
  CHECK(free.report.target_met == true);
  CHECK(free.report.lost.handles > 0);
  CHECK(free.defects.duplicates + free.defects.degenerate + free.defects.boundary_edges == 0);
}

TEST_CASE("a count that leaves room for all holes closes none", "[shapes]") {
  const Shape shape = sieve(3, 4);
  SimplifyOptions options = to_count(600);
  options.topology = Topology::free;
  const RefinedShape out = refine_shape(shape, {}, options);
  CHECK(out.output.faces.size() == 600);
  CHECK(is_closed(out));
  CHECK(out.report.lost.handles == 0);
  CHECK(euler_of(out.output) == euler_of(out.input));
}

TEST_CASE("kept boundaries and kept pieces are named where they keep the count from being met",
          "[shapes]") {
  SimplifyOptions options = to_count(50);
  options.boundary = Boundary::keep;
  options.topology = GENERATE(Topology::keep, Topology::free);
  const RefinedShape disc = refine_shape(shapes::disc(60, 20), {}, options);
  CHECK(disc.report.target_met == false);
  CHECK(disc.report.refine.stopped_by == StoppedBy::boundaries);
  CHECK(disc.output.faces.size() <= 62);
  REQUIRE(!disc.report.notes.empty());
  CHECK(disc.report.notes[0].find("`boundary` keep keeps") != std::string::npos);
  options.boundary = Boundary::weigh;
  options.keep_pieces = true;
  const RefinedShape soup = refine_shape(shapes::soup(100, 0.1), {}, options);
  CHECK(soup.report.refine.stopped_by == StoppedBy::pieces);
  CHECK(soup.output.faces.size() == 100);
}

}  // namespace winnow::test
