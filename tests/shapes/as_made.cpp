// The shapes are what they are said to be, and measures tell.
#include "support/refined_shape.hpp"

#include <cmath>
#include <numbers>

namespace winnow::test {

namespace {

double area_of_polygon(std::size_t corners) {
  const auto n = static_cast<double>(corners);
  return n / 2 * std::sin(2 * std::numbers::pi / n);
}

void check_closed(const Shape& shape, double enclosed) {
  const std::optional<double> measured = volume(shape);
  REQUIRE(measured);
  CHECK(*measured == Approx(enclosed).epsilon(1e-9));
  CHECK(border_of(shape).empty());
  CHECK(*volume(turned(shape, 0.4)) == Approx(enclosed).epsilon(1e-9));
  CHECK(*volume(inside_out(shape)) == Approx(-enclosed).epsilon(1e-9));
}

}  // namespace

TEST_CASE("closed shapes enclose what they should", "[shapes]") {
  check_closed(shapes::plate(7, 0.001), 0.001);
  check_closed(shapes::pipe(12, 5, 1000), 1000 * area_of_polygon(12));
  check_closed(shapes::capped_cylinder(100), area_of_polygon(100));
  check_closed(shapes::capped_cube(5), 1);
  check_closed(shapes::cube_with_caps(5), 1);
  CHECK(*volume(shapes::double_sided(5)) == Approx(0).margin(1e-9));
  const double ball = *volume(shapes::far_vertex(20, 1e6, false));
  CHECK(ball < 4 * std::numbers::pi / 3);
  CHECK(ball > 4.15);
  CHECK(*volume(shapes::thin_shell(20, 0.1)) == Approx(ball * (1 - 0.9 * 0.9 * 0.9)));
  const double bust = 0.2 * 0.2 * 0.2 * ball;
  CHECK(*volume(shapes::room(3, 20)) == Approx(bust - 60));
}

TEST_CASE("shapes have the area that they should", "[shapes]") {
  CHECK(area(shapes::open_fan(1000)) == Approx(area_of_polygon(1000)));
  CHECK(area(shapes::disc(30, 7)) == Approx(area_of_polygon(30)));
  CHECK(area(shapes::strip(10, 0.02)) == Approx(0.02));
  CHECK(area(shapes::polygon_square(7)) == Approx(1));
  CHECK(area(shapes::zero_area_border_square()) == Approx(1));
  CHECK(area(shapes::capped_cube(9)) == Approx(6));
  CHECK(area(shapes::cube_with_caps(9)) == Approx(6));
  CHECK(area(shapes::line(50)) == 0);
  CHECK(faces_without_area(shapes::line(50)) == 48);
  CHECK(faces_without_area(shapes::zero_area_border_square()) == 1);
  CHECK(faces_without_area(shapes::polygon_square(3)) == 6);
  CHECK(area(shapes::book(10)) == Approx(5));
  CHECK(area(shapes::hills(50, 0)) == Approx(1));
}

TEST_CASE("edges have the faces that they should", "[shapes]") {
  CHECK(defects_of(shapes::book(10).faces).crowded == 1);
  CHECK(defects_of(shapes::double_sided(3).faces).crowded == 108 * 3 / 2);
  CHECK(defects_of(shapes::double_sided(3).faces).duplicates == 108);
  CHECK(defects_of(shapes::hub(100).faces).boundary_edges == 300);
  CHECK(defects_of(shapes::soup(100).faces).boundary_edges == 300);
  CHECK(defects_of(shapes::crowd(1000, 50).faces).degenerate == 0);
  CHECK(border_of(shapes::hills(10)).size() == 40);
  CHECK(border_of(shapes::open_fan(77)).size() == 77);
}

TEST_CASE("the parts of a shape are where they should be", "[shapes]") {
  CHECK(faces_near(shapes::ball_on_ground(5, 3, 100), shapes::ball_on_ground_middle, 0.51) == 300);
  CHECK(faces_near(turned(shapes::room(3, 4), 0.4), turned(shapes::room_bust_middle, 0.4), 0.21) ==
        192);
  // A square inside of another, 0.1 away on all sides: its corners are nearer than those of the
  // other.
  const std::vector<Segment> inner = border_of(shapes::polygon_square(0));
  Shape larger = shapes::polygon_square(0);
  for (Point& p : larger.vertices) {
    for (std::size_t k = 0; k < 2; ++k) p[k] = 1.2 * p[k] - 0.1;
  }
  CHECK(border_distance(inner, border_of(larger), 3) == Approx(0.1));
  CHECK(border_distance(border_of(larger), inner, 3) == Approx(0.1 * std::sqrt(2)));
}

TEST_CASE("a shape comes back from its file as it was stored", "[shapes]") {
  const Directory directory;
  const std::string path = directory.file("shape.ply");
  for (const Numbers numbers : {Numbers::floats, Numbers::doubles}) {
    const Shape shape = as_stored(turned(shapes::hills(5), 1.1), numbers);
    write_file(path, ply_of(shape, numbers));
    const Shape back = read_shape(path);
    CHECK(back.vertices == shape.vertices);
    CHECK(back.faces == shape.faces);
  }
}

}  // namespace winnow::test
