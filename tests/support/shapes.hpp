// Shapes on which simplifiers go wrong, of any size.
#pragma once

#include "base/vector.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow::test {

struct Shape {
  std::vector<Point> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

namespace shapes {

// A ball of radius 1 and one inside of it, turned inside out. 24 n^2 faces, closed.
Shape thin_shell(std::size_t n = 400, double wall = 0.01);
// A box of 1 x 1 x thickness. 12 n^2 faces, closed; 12 are exact.
Shape plate(std::size_t n = 300, double thickness = 0.001);
// A ball of radius 0.5 over the middle of a flat square of 2 cells^2 faces, of which two are exact.
Shape ball_on_ground(std::size_t n = 32, std::size_t cells = 30, double side = 1000);
inline constexpr Point ball_on_ground_middle{0, 0, 0.6};
// The walls of a box of 5 x 4 x 3, seen from inside, and a ball of radius 0.2 in it. 12 faces are
// exact walls.
Shape room(std::size_t n = 24, std::size_t bust = 32);
inline constexpr Point room_bust_middle{2, 2, 1.2};
// Straight and closed, of radius 1: 4 sides - 4 faces are exact.
Shape pipe(std::size_t sides = 12, std::size_t rings = 400, double length = 1000);
// Closed, of radius and height 1. Each cap is one fan around a vertex.
Shape capped_cylinder(std::size_t sides = 25'000);
// A disc of radius 1: one fan around a vertex.
Shape open_fan(std::size_t n = 100'000);
// Pages around one edge.
Shape book(std::size_t pages = 1000);
// Thin faces that share one vertex and nothing else.
Shape hub(std::size_t n = 100'000, std::uint64_t seed = 1);
// Vertices on a line, faces between each three that follow each other: no area anywhere.
Shape line(std::size_t n = 400'000);
// Loose faces.
Shape soup(std::size_t n = 100'000, double size = 1, std::uint64_t seed = 1);
// A ball of 12 n^2 faces, each with corners of its own that are off by as much.
Shape jittered_soup(std::size_t n = 20, double jitter = 1e-6, std::uint64_t seed = 1);
// Random faces between so many random vertices: edges with many faces, vertices with very many.
Shape crowd(std::size_t faces = 1'000'000, std::size_t vertices = 2000, std::uint64_t seed = 1);
// A cube, each side one fan from a corner over n points an edge: faces along two edges of it have
// no area.
Shape capped_cube(std::size_t n = 40);
// A cube, edges of which have n points on one side; faces without area join them to the other.
Shape cube_with_caps(std::size_t n = 40);
// The unit square in three faces, one of them without area at the border.
Shape zero_area_border_square();
// The unit square as one polygon with so many points inside of each side, cut into a fan from a
// corner.
Shape polygon_square(std::size_t points = 3);
// A flat disc of radius 1 in rings.
Shape disc(std::size_t n = 60, std::size_t rings = 20);
// Flat, of length 1: 2 n faces in a row.
Shape strip(std::size_t n = 100, double width = 0.02);
// Each face of a ball twice, the second time in the other sense.
Shape double_sided(std::size_t n = 17);
// A ball and a vertex far away, which one face uses, or none.
Shape far_vertex(std::size_t n = 100, double far = 1e6, bool used = true);
// The graph of a function over the unit square, 2 n^2 faces.
Shape hills(std::size_t n = 800, double height = 0.1);

}  // namespace shapes

// Turned by so much about two axes, so that nothing lies along an axis any more.
Point turned(const Point& p, double angle);
Shape turned(Shape shape, double angle);

// The same with its faces the other way round, and with the vertices and faces of another.
Shape inside_out(Shape shape);
Shape joined(Shape shape, const Shape& other);

std::vector<Triangle> triangles_of(const Shape& shape);

}  // namespace winnow::test
