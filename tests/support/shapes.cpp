#include "support/shapes.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace winnow::test {

namespace shapes {

namespace {

using Corners = std::array<std::uint32_t, 3>;

std::uint32_t number(std::size_t i) {
  return static_cast<std::uint32_t>(i);
}

void add_face(Shape& shape, std::size_t a, std::size_t b, std::size_t c) {
  shape.faces.push_back({number(a), number(b), number(c)});
}

void add_quad(Shape& shape, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
  add_face(shape, a, b, c);
  add_face(shape, a, c, d);
}

double share(std::size_t i, std::size_t n) {
  return static_cast<double>(i) / static_cast<double>(n);
}

// Vertices at(u, v), u and v from 0 to 1 in so many steps.
template <typename At>
Shape grid(std::size_t n, std::size_t m, const At& at) {
  Shape shape;
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= m; ++j) {
      shape.vertices.push_back(at(share(i, n), share(j, m)));
      const std::size_t v = i * (m + 1) + j;
      if (i < n && j < m) add_quad(shape, v, v + m + 1, v + m + 2, v + 1);
    }
  }
  return shape;
}

// Vertices that agree to the twelfth digit become one; faces that this takes a corner from go.
Shape welded(const Shape& shape) {
  std::vector<Point> places = shape.vertices;
  for (Point& p : places) {
    for (double& x : p) x = std::round(x * 1e12) / 1e12 + 0.0;
  }
  Shape out;
  out.vertices = places;
  std::sort(out.vertices.begin(), out.vertices.end());
  out.vertices.erase(std::unique(out.vertices.begin(), out.vertices.end()), out.vertices.end());
  std::vector<std::uint32_t> numbers;
  for (const Point& p : places) {
    const auto found = std::lower_bound(out.vertices.begin(), out.vertices.end(), p);
    numbers.push_back(number(static_cast<std::size_t>(found - out.vertices.begin())));
  }
  for (const auto& [a, b, c] : shape.faces) {
    const Corners face{numbers[a], numbers[b], numbers[c]};
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) out.faces.push_back(face);
  }
  return out;
}

// Each side in n x n cells.
Shape box(std::size_t n, const Point& low, const Point& high) {
  Shape sides;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool end : {false, true}) {
      const std::size_t along = (axis + (end ? 1 : 2)) % 3;
      const std::size_t across = (axis + (end ? 2 : 1)) % 3;
      sides = joined(std::move(sides), grid(n, n, [&](double u, double v) {
                       Point p{};
                       p[axis] = end ? 1 : 0;
                       p[along] = u;
                       p[across] = v;
                       for (std::size_t k = 0; k < 3; ++k)
                         p[k] = low[k] + p[k] * (high[k] - low[k]);
                       return p;
                     }));
    }
  }
  return welded(sides);
}

Shape ball(std::size_t n, double radius = 1, const Point& middle = {}) {
  Shape shape = box(n, {-1, -1, -1}, {1, 1, 1});
  for (Point& p : shape.vertices) p = radius * unit(p) + middle;
  return shape;
}

std::vector<Point> circle(std::size_t n, double radius = 1, double z = 0) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * share(i, n);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  return points;
}

void add_points(Shape& shape, const std::vector<Point>& points) {
  shape.vertices.insert(shape.vertices.end(), points.begin(), points.end());
}

Point random_direction(Random& random) {
  // Evenly over the sphere (Archimedes).
  const double z = random.real(-1, 1);
  const double angle = random.real(0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// In a cube of this half side.
Point random_point(Random& random, double half) {
  Point p;
  for (double& x : p) x = random.real(-half, half);
  return p;
}

}  // namespace

Shape thin_shell(std::size_t n, double wall) {
  return joined(ball(n), inside_out(ball(n, 1 - wall)));
}

Shape plate(std::size_t n, double thickness) {
  return box(n, {0, 0, 0}, {1, 1, thickness});
}

Shape ball_on_ground(std::size_t n, std::size_t cells, double side) {
  return joined(ball(n, 0.5, ball_on_ground_middle), grid(cells, cells, [&](double u, double v) {
                  return Point{(u - 0.5) * side, (v - 0.5) * side, 0};
                }));
}

Shape room(std::size_t n, std::size_t bust) {
  return joined(inside_out(box(n, {0, 0, 0}, {5, 4, 3})), ball(bust, 0.2, room_bust_middle));
}

Shape pipe(std::size_t sides, std::size_t rings, double length) {
  Shape shape;
  for (std::size_t ring = 0; ring <= rings; ++ring) {
    add_points(shape, circle(sides, 1, share(ring, rings) * length));
    if (ring == rings) break;
    for (std::size_t i = 0; i < sides; ++i) {
      const std::size_t a = ring * sides + i;
      const std::size_t b = ring * sides + (i + 1) % sides;
      add_quad(shape, a, b, b + sides, a + sides);
    }
  }
  for (std::size_t i = 1; i + 1 < sides; ++i) {
    add_face(shape, 0, i + 1, i);
    add_face(shape, rings * sides, rings * sides + i, rings * sides + i + 1);
  }
  return shape;
}

Shape capped_cylinder(std::size_t sides) {
  Shape shape;
  add_points(shape, circle(sides));
  add_points(shape, circle(sides, 1, 1));
  add_points(shape, {{0, 0, 0}, {0, 0, 1}});
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t j = (i + 1) % sides;
    add_quad(shape, i, j, j + sides, i + sides);
    add_face(shape, 2 * sides, j, i);
    add_face(shape, 2 * sides + 1, i + sides, j + sides);
  }
  return shape;
}

Shape open_fan(std::size_t n) {
  return disc(n, 1);
}

Shape book(std::size_t pages) {
  Shape shape;
  add_points(shape, {{0, 0, 0}, {0, 0, 1}});
  add_points(shape, circle(pages, 1, 0.5));
  for (std::size_t i = 0; i < pages; ++i) add_face(shape, 0, 1, i + 2);
  return shape;
}

Shape hub(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Shape shape;
  shape.vertices.push_back({});
  for (std::size_t i = 0; i < n; ++i) {
    const Point p = random_direction(random);
    add_points(shape, {p, p + random_point(random, 0.017)});
    add_face(shape, 0, 2 * i + 1, 2 * i + 2);
  }
  return shape;
}

Shape line(std::size_t n) {
  Shape shape;
  for (std::size_t i = 0; i < n; ++i) {
    shape.vertices.push_back({share(i, n - 1), 0, 0});
    if (i + 2 < n) add_face(shape, i, i + 1, i + 2);
  }
  return shape;
}

Shape soup(std::size_t n, double size, std::uint64_t seed) {
  Random random(seed);
  Shape shape;
  for (std::size_t i = 0; i < n; ++i) {
    const Point place = random_point(random, 0.5);
    for (int corner = 0; corner < 3; ++corner)
      shape.vertices.push_back(place + random_point(random, size / 2));
    add_face(shape, 3 * i, 3 * i + 1, 3 * i + 2);
  }
  return shape;
}

Shape jittered_soup(std::size_t n, double jitter, std::uint64_t seed) {
  Random random(seed);
  const Shape whole = ball(n);
  Shape shape;
  for (const Corners& face : whole.faces) {
    const std::size_t first = shape.vertices.size();
    for (const std::uint32_t v : face)
      shape.vertices.push_back(whole.vertices[v] + random_point(random, jitter));
    add_face(shape, first, first + 1, first + 2);
  }
  return shape;
}

Shape crowd(std::size_t faces, std::size_t vertices, std::uint64_t seed) {
  Random random(seed);
  Shape shape;
  for (std::size_t i = 0; i < vertices; ++i) shape.vertices.push_back(random_point(random, 0.5));
  for (std::size_t i = 0; i < faces; ++i) {
    const std::size_t a = random.below(vertices);
    const std::size_t b = (a + 1 + random.below(vertices - 1)) % vertices;
    std::size_t c = random.below(vertices);
    while (c == a || c == b) c = random.below(vertices);
    add_face(shape, a, b, c);
  }
  return shape;
}

Shape capped_cube(std::size_t n) {
  Shape shape;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool end : {false, true}) {
      const auto at = [&](const std::array<double, 2>& p) {
        Point place{};
        place[axis] = end ? 1 : 0;
        place[(axis + 1) % 3] = p[0];
        place[(axis + 2) % 3] = p[1];
        return place;
      };
      const std::size_t first = shape.vertices.size();
      for (std::size_t side = 0; side < 4; ++side) {
        for (std::size_t i = 0; i < n; ++i) {
          const double t = share(i, n);
          const std::array<std::array<double, 2>, 4> ring{{{t, 0}, {1, t}, {1 - t, 1}, {0, 1 - t}}};
          shape.vertices.push_back(at(ring.at(side)));
        }
      }
      for (std::size_t i = 1; i + 1 < 4 * n; ++i) {
        const std::size_t next = i + 1;
        add_face(shape, first, first + (end ? i : next), first + (end ? next : i));
      }
    }
  }
  return welded(shape);
}

Shape cube_with_caps(std::size_t n) {
  Shape shape = box(1, {0, 0, 0}, {1, 1, 1});
  std::set<std::pair<std::uint32_t, std::uint32_t>> split;
  for (const Corners& face : std::exchange(shape.faces, {})) {
    const auto [a, b, c] = face;
    if (!split.insert(std::minmax({a, b})).second) {
      shape.faces.push_back(face);
      continue;
    }
    // This face becomes a fan over points of its first side, the beyond of which goes on as one
    // edge.
    const std::size_t first = shape.vertices.size();
    for (std::size_t i = 1; i <= n; ++i)
      shape.vertices.push_back(shape.vertices[a] +
                               share(i, n + 1) * (shape.vertices[b] - shape.vertices[a]));
    for (std::size_t i = 0; i <= n; ++i) {
      const std::size_t from = i == 0 ? a : first + i - 1;
      const std::size_t to = i == n ? b : first + i;
      add_face(shape, from, to, c);
      if (i > 0) add_face(shape, a, to, from);
    }
  }
  return shape;
}

Shape zero_area_border_square() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 0}},
          {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}}};
}

Shape polygon_square(std::size_t points) {
  Shape shape;
  const std::size_t side = points + 1;
  for (std::size_t i = 0; i < side; ++i) shape.vertices.push_back({share(i, side), 0, 0});
  for (std::size_t i = 0; i < side; ++i) shape.vertices.push_back({1, share(i, side), 0});
  for (std::size_t i = 0; i < side; ++i) shape.vertices.push_back({1 - share(i, side), 1, 0});
  for (std::size_t i = 0; i < side; ++i) shape.vertices.push_back({0, 1 - share(i, side), 0});
  for (std::size_t i = 1; i + 1 < shape.vertices.size(); ++i) add_face(shape, 0, i, i + 1);
  return shape;
}

Shape disc(std::size_t n, std::size_t rings) {
  Shape shape;
  shape.vertices.push_back({});
  for (std::size_t ring = 1; ring <= rings; ++ring) {
    add_points(shape, circle(n, share(ring, rings)));
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = 1 + (ring - 1) * n + i;
      const std::size_t b = 1 + (ring - 1) * n + (i + 1) % n;
      if (ring == 1) {
        add_face(shape, 0, a, b);
      } else {
        add_quad(shape, a - n, a, b, b - n);
      }
    }
  }
  return shape;
}

Shape strip(std::size_t n, double width) {
  return grid(n, 1, [&](double u, double v) { return Point{u, v * width, 0}; });
}

Shape double_sided(std::size_t n) {
  Shape shape = ball(n);
  const Shape other = inside_out(shape);
  shape.faces.insert(shape.faces.end(), other.faces.begin(), other.faces.end());
  return shape;
}

Shape far_vertex(std::size_t n, double far, bool used) {
  Shape shape = ball(n);
  shape.vertices.push_back({far, 0, 0});
  if (used) add_face(shape, 0, 1, shape.vertices.size() - 1);
  return shape;
}

Shape hills(std::size_t n, double height) {
  return grid(n, n, [&](double u, double v) {
    return Point{u, v, height * std::sin(9 * u) * std::cos(7 * v)};
  });
}

}  // namespace shapes

Point turned(const Point& p, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double y = c * p[1] - s * p[2];
  const double z = s * p[1] + c * p[2];
  return {c * p[0] - s * y, s * p[0] + c * y, z};
}

Shape turned(Shape shape, double angle) {
  if (angle == 0) return shape;
  for (Point& p : shape.vertices) p = turned(p, angle);
  return shape;
}

Shape inside_out(Shape shape) {
  for (auto& face : shape.faces) std::swap(face[1], face[2]);
  return shape;
}

Shape joined(Shape shape, const Shape& other) {
  const auto first = static_cast<std::uint32_t>(shape.vertices.size());
  shape.vertices.insert(shape.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.faces)
    shape.faces.push_back({first + a, first + b, first + c});
  return shape;
}

std::vector<Triangle> triangles_of(const Shape& shape) {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : shape.faces)
    triangles.push_back({shape.vertices[a], shape.vertices[b], shape.vertices[c]});
  return triangles;
}

}  // namespace winnow::test
