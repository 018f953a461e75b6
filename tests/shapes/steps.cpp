// The work grows with the faces, however many of them meet at a vertex or an edge.
#include "support/steps.hpp"

#include "support/shapes.hpp"

#include <functional>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// Of all faces, refined to a twentieth of them.
double steps_a_face(const Shape& shape) {
  const std::uint64_t faces = shape.faces.size();
  return static_cast<double>(steps_of_refining(shape, faces / 20)) / static_cast<double>(faces);
}

// Four times the faces: four times the work, and a little for what is sorted. Nor does a face cost
// much more than one of a ball.
void check_steps(const std::function<Shape(std::size_t)>& make, std::size_t n) {
  const double few = steps_a_face(make(n));
  const double many = steps_a_face(make(4 * n));
  const double usual = steps_a_face(shapes::far_vertex(30, 1, false));
  CAPTURE(n, few, many, usual);
  CHECK(usual > 1);
  CHECK(many < 1.5 * few + usual);
  CHECK(many < 30 * usual);
}

}  // namespace

TEST_CASE("the work on a surface grows with its faces", "[shapes]") {
  check_steps([](std::size_t n) { return shapes::soup(n, 0.1); }, 5000);
  check_steps([](std::size_t n) { return shapes::disc(n, 10); }, 100);
  check_steps([](std::size_t n) { return shapes::strip(n); }, 2000);
}

TEST_CASE("the work on a fan grows with its faces", "[shapes]") {
  check_steps([](std::size_t n) { return shapes::open_fan(n); }, 5000);
  check_steps([](std::size_t n) { return shapes::capped_cylinder(n); }, 2000);
  check_steps([](std::size_t n) { return shapes::polygon_square(n); }, 1000);
}

TEST_CASE("the work on a hub grows with its faces", "[shapes]") {
  check_steps([](std::size_t n) { return shapes::hub(n); }, 3000);
}

TEST_CASE("the work on a book grows with its pages", "[shapes]") {
  check_steps([](std::size_t n) { return shapes::book(n); }, 500);
}

TEST_CASE("the work on faces without area grows with their number", "[shapes]") {
  check_steps([](std::size_t n) { return shapes::line(n); }, 5000);
}

TEST_CASE("the work on very many faces of few vertices grows with their number", "[shapes]") {
  check_steps([](std::size_t n) { return shapes::crowd(n, 300); }, 3000);
}

}  // namespace winnow::test
