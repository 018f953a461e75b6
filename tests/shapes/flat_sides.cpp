// Flat sides take the fewest faces that they need, stay exactly where they are, and leave the rest
// to what has shape.
#include "support/refined_shape.hpp"

#include <algorithm>
#include <cmath>

namespace winnow::test {

namespace {

// Vertices outside of a ball lie on a side of the box, to the bit.
void check_on_sides(const Shape& shape, const Box& box, const Point& middle, double radius) {
  for (const Point& p : shape.vertices) {
    if (length(p - middle) <= radius) continue;
    bool on_side = false;
    for (std::size_t k = 0; k < 3; ++k)
      on_side = on_side || p[k] == box.low[k] || p[k] == box.high[k];
    CAPTURE(p[0], p[1], p[2]);
    CHECK(on_side);
  }
}

}  // namespace

TEST_CASE("a ball on flat ground keeps the faces", "[shapes]") {
  struct Ground {
    std::size_t ball, cells;
    double side;
  };
  for (const Ground& ground : {Ground{32, 30, 1000}, Ground{20, 60, 100}, Ground{32, 9, 10}}) {
    CAPTURE(ground.ball, ground.cells, ground.side);
    const Shape shape = shapes::ball_on_ground(ground.ball, ground.cells, ground.side);
    for_each_pose([&](const Pose& pose) {
      const RefinedShape out = refine_shape(shape, pose, to_count(1000));
      CHECK(out.output.faces.size() <= 1000);
      CHECK(out.output.faces.size() >= 998);
      const Point middle = turned(shapes::ball_on_ground_middle, pose.angle);
      const double spacing = spacing_of(out.input, pose.numbers);
      CHECK(faces_near(out.output, middle, 0.51 + 2 * spacing) >= 950);
      CHECK(area(out.output) == Approx(area(out.input)).epsilon(1e-3));
      // The ground is whole: its four corners alone are its border's corners.
      double border = 0;
      for (const Segment& edge : border_of(out.output)) border += length(edge[1] - edge[0]);
      CHECK(border == Approx(4 * ground.side).epsilon(1e-4));
      if (pose.angle != 0) return;
      for (const Point& p : out.output.vertices) {
        if (length(p - middle) > 0.52) CHECK(p[2] == 0);
      }
    });
  }
}

TEST_CASE("a bust in a room of flat walls keeps the faces", "[shapes]") {
  struct Room {
    std::size_t walls, bust;
  };
  for (const Room& room : {Room{24, 32}, Room{40, 24}}) {
    CAPTURE(room.walls, room.bust);
    const Shape shape = shapes::room(room.walls, room.bust);
    for_each_pose([&](const Pose& pose) {
      const RefinedShape out = refine_shape(shape, pose, to_count(1100));
      CHECK(out.output.faces.size() == 1100);
      CHECK(is_closed(out));
      const Point middle = turned(shapes::room_bust_middle, pose.angle);
      CHECK(faces_near(out.output, middle, 0.21) >= 1050);
      const std::optional<double> before = volume(out.input);
      const std::optional<double> after = volume(out.output);
      REQUIRE(before);
      REQUIRE(after);
      CHECK(*after == Approx(*before).epsilon(1e-4));
      if (pose.angle == 0) check_on_sides(out.output, box_of(out.input), middle, 0.25);
    });
  }
}

TEST_CASE("a plate becomes twelve faces", "[shapes]") {
  for (const double thickness : {0.001, 0.1}) {
    for (const std::size_t n : {8, 30, 60}) {
      CAPTURE(thickness, n);
      const Shape shape = shapes::plate(n, thickness);
      for_each_pose([&](const Pose& pose) {
        for (const std::uint64_t faces : {12, 60, 200}) {
          CAPTURE(faces);
          const RefinedShape out = refine_shape(shape, pose, to_count(faces));
          CHECK(out.output.faces.size() == faces);
          CHECK(is_closed(out));
          const std::optional<double> left = volume(out.output);
          REQUIRE(left);
          const double rounding = 8 * spacing_of(out.input, pose.numbers) / thickness;
          CHECK(std::abs(*left / thickness - 1) < 1e-5 + rounding);
          CHECK(area(out.output) == Approx(area(out.input)).epsilon(1e-5));
          if (pose.angle == 0) check_on_sides(out.output, box_of(out.input), {}, -1);
        }
      });
    }
  }
}

TEST_CASE("a straight pipe keeps its volume", "[shapes]") {
  struct Pipe {
    std::size_t sides, rings;
    double length;
    std::uint64_t faces;
  };
  for (const Pipe& pipe :
       {Pipe{12, 400, 1000, 200}, Pipe{12, 400, 1000, 44}, Pipe{24, 200, 1000, 200},
        Pipe{24, 2000, 100'000, 1000}, Pipe{6, 1000, 1'000'000, 20}}) {
    CAPTURE(pipe.sides, pipe.rings, pipe.length, pipe.faces);
    const Shape shape = shapes::pipe(pipe.sides, pipe.rings, pipe.length);
    const std::optional<double> exact = volume(shape);
    REQUIRE(exact);
    for_each_pose([&](const Pose& pose) {
      const RefinedShape out =
          refine_shape(shape, pose, to_count(std::max(pipe.faces, 4 * pipe.sides - 4)));
      CHECK(out.output.faces.size() <= std::max(pipe.faces, 4 * pipe.sides - 4));
      CHECK(is_closed(out));
      const std::optional<double> left = volume(out.output);
      REQUIRE(left);
      // What positions are rounded by, beside a radius of 1.
      const double rounding = 2 * spacing_of(out.input, pose.numbers);
      CHECK(std::abs(*left / *exact - 1) < 1e-5 + rounding);
      if (pose.angle != 0) return;
      for (const Point& p : out.output.vertices) {
        if (p[2] < pipe.length / 1e4) CHECK(p[2] == 0);
        if (p[2] > pipe.length * (1 - 1e-4)) CHECK(p[2] == pipe.length);
      }
    });
  }
}

TEST_CASE("a thin shell is refined to any count", "[shapes]") {
  const double wall = 0.05;
  const Shape shape = shapes::thin_shell(40, wall);
  for_each_pose([&](const Pose& pose) {
    for (const std::uint64_t faces : {10'000, 3000, 1000}) {
      CAPTURE(faces);
      const RefinedShape out = refine_shape(shape, pose, to_count(faces));
      CHECK(out.output.faces.size() == faces);
      CHECK(is_closed(out));
      const std::optional<double> before = volume(out.input);
      const std::optional<double> after = volume(out.output);
      REQUIRE(before);
      REQUIRE(after);
      // Once faces are longer than a few walls, nothing can be said.
      if (faces > 2000) CHECK(*after == Approx(*before).epsilon(0.02));
    }
  });
}

}  // namespace winnow::test
