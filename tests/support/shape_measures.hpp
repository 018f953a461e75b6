// What can be measured on any mesh.
#pragma once

#include "base/box.hpp"
#include "support/shapes.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace winnow::test {

double area(const Shape& shape);
// What it encloses; nothing where it is not closed: each side of a face has to be met by its
// opposite.
std::optional<double> volume(const Shape& shape);
Box box_of(const Shape& shape);
std::size_t faces_without_area(const Shape& shape);
// Faces all of whose corners are so near to a point.
std::size_t faces_near(const Shape& shape, const Point& middle, double radius);

// Edges of one face.
using Segment = std::array<Point, 2>;
std::vector<Segment> border_of(const Shape& shape);
// The largest distance of a point of the one border from the other: of vertices, and of `inner`
// points an edge.
double border_distance(const std::vector<Segment>& from, const std::vector<Segment>& to,
                       std::size_t inner);

}  // namespace winnow::test
