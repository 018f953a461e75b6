// Any number of faces around a vertex or an edge.
#include <winnow/error.hpp>

#include "support/refined_shape.hpp"
#include "support/text_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace winnow::test {

namespace {

double area_of_inscribed(std::size_t corners) {
  const auto n = static_cast<double>(corners);
  return n / 2 * std::sin(2 * std::numbers::pi / n);
}

// A clear end: no more faces than were asked for, or the reason why there are more, or none at all.
void check_ends(const Shape& shape, const SimplifyOptions& options) {
  try {
    const RefinedShape out = refine_shape(shape, {}, options);
    CAPTURE(out.output.faces.size());
    CHECK((out.output.faces.size() <= options.target.faces().value_or(UINT64_MAX) ||
           !out.report.missed_by.empty()));
    CHECK(out.defects.degenerate + out.defects.duplicates == 0);
  } catch (const Error& error) {
    CAPTURE(error.what());
    CHECK(error.kind() == ErrorKind::failed);
  }
}

}  // namespace

TEST_CASE("an open fan stays round at any count", "[shapes]") {
  for (const std::size_t n : {100, 1000, 20'000, 100'000}) {
    const Shape shape = shapes::open_fan(n);
    for (const std::uint64_t faces : {6, 16, 60}) {
      for (const Pose& pose : {Pose{0, Numbers::floats}, Pose{0.4, Numbers::doubles}}) {
        CAPTURE(n, faces, pose.angle);
        const RefinedShape out = refine_shape(shape, pose, to_count(faces));
        CHECK(out.output.faces.size() <= faces);
        CHECK(out.output.faces.size() + 1 >= faces);
        CHECK(out.defects.crowded + out.defects.discords == 0);
        CHECK(area(out.output) >= 0.97 * area_of_inscribed(border_of(out.output).size()));
        CHECK(area(out.output) >= 0.97 * area_of_inscribed(faces));
      }
    }
  }
}

TEST_CASE("a cylinder with caps of one fan keeps its volume", "[shapes]") {
  for (const std::size_t sides : {1000, 25'000, 30'000, 40'000}) {
    const Shape shape = shapes::capped_cylinder(sides);
    for (const Pose& pose : {Pose{0, Numbers::floats}, Pose{1.1, Numbers::doubles}}) {
      CAPTURE(sides, pose.angle);
      const RefinedShape out = refine_shape(shape, pose, to_count(1000));
      CHECK(out.output.faces.size() == 1000);
      CHECK(is_closed(out));
      CHECK(std::abs(volume(out.output).value_or(0) / *volume(shape) - 1) < 1e-3);
    }
  }
}

TEST_CASE("a polygon of very many corners becomes what was asked for", "[shapes]") {
  for (const std::size_t points : {250, 5000, 25'000}) {
    CAPTURE(points);
    const RefinedShape out = refine_shape(shapes::polygon_square(points), {}, to_count(4));
    CHECK(out.output.faces.size() <= 4);
    CHECK(std::abs(area(out.output) - 1) < 1e-6);
  }
}

TEST_CASE("a book of any pages ends", "[shapes]") {
  for (const std::size_t pages : {100, 1000, 4000}) {
    CAPTURE(pages);
    const Shape shape = shapes::book(pages);
    check_ends(shape, to_count(pages / 10));
    check_ends(shape, to_relative_error(0.01));
  }
}

TEST_CASE("faces without area along a line end", "[shapes]") {
  for (const std::size_t n : {1000, 100'000}) {
    CAPTURE(n);
    check_ends(shapes::line(n), to_count(100));
    check_ends(turned(shapes::line(n), 0.4), to_count(100));
    check_ends(shapes::line(n), to_relative_error(0.01));
  }
}

TEST_CASE("faces that share one vertex and nothing else end", "[shapes]") {
  for (const std::size_t n : {1000, 30'000, 100'000}) {
    CAPTURE(n);
    check_ends(shapes::hub(n), to_count(n / 100));
    check_ends(shapes::hub(n, 2), to_relative_error(0.01));
  }
}

TEST_CASE("very many faces on few vertices end", "[shapes]") {
  for (const std::size_t faces : {10'000, 100'000}) {
    CAPTURE(faces);
    check_ends(shapes::crowd(faces), to_count(faces / 10));
    check_ends(shapes::crowd(faces, 2000, 2), to_relative_error(0.01));
  }
}

TEST_CASE("a free topology meets the count however many faces are around vertices", "[shapes]") {
  const Refine cost = GENERATE(Refine::quadric, Refine::volume);
  for (const Shape& shape :
       {shapes::crowd(50'000, 300), shapes::crowd(100'000, 2000), shapes::crowd(30'000, 1500, 2),
        shapes::open_fan(30'000), shapes::hub(20'000), shapes::book(3000), shapes::soup(5000),
        joined(shapes::crowd(20'000, 200), shapes::hills(40))}) {
    for (const std::uint64_t faces : {5, 60, 1000}) {
      CAPTURE(shape.faces.size(), shape.vertices.size(), faces);
      SimplifyOptions options = to_count(faces);
      options.topology = Topology::free;
      options.refine = cost;
      const RefinedShape out = refine_shape(shape, {}, options);
      CHECK(out.output.faces.size() <= faces);
      CHECK(out.output.faces.size() > 0);
      CHECK(out.report.target_met == true);
      CHECK(out.report.missed_by.empty());
      CHECK(out.defects.degenerate + out.defects.duplicates == 0);
    }
  }
}

TEST_CASE("loose faces end", "[shapes]") {
  const Shape shape = shapes::soup(50'000);
  check_ends(shape, to_count(5000));
  check_ends(shape, to_relative_error(0.01));
}

}  // namespace winnow::test
