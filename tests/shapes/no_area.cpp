// Faces without area neither hinder nor cost anything.
#include "support/refined_shape.hpp"
#include "support/text_meshes.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace winnow::test {

namespace {

void check_cube(const Shape& shape) {
  CHECK(faces_without_area(shape) > 0);
  for_each_pose([&](const Pose& pose) {
    const RefinedShape out = refine_shape(shape, pose, to_count(12));
    CHECK(out.output.faces.size() == 12);
    CHECK(is_closed(out));
    CHECK(std::abs(volume(out.output).value_or(0) - 1) < 1e-5);
    CHECK(std::abs(area(out.output) - 6) < 1e-5);
  });
}

// As text of so many digits, or decimals, is read back.
Shape written(Shape shape, const char* format) {
  for (Point& p : shape.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<char, 64> text{};
      std::snprintf(text.data(), text.size(), format, p[axis]);
      p[axis] = std::strtod(text.data(), nullptr);
    }
  }
  return shape;
}

// An OBJ whose one face is the border of a polygon.
RefinedShape refine_polygon(const Shape& polygon, const SimplifyOptions& options) {
  const Directory directory;
  const std::string input = directory.file("in.obj");
  const std::string output = directory.file("out.ply");
  Polygons mesh{polygon.vertices, {{}}};
  for (std::size_t v = 0; v < polygon.vertices.size(); ++v)
    mesh.faces[0].push_back(static_cast<std::int64_t>(v));
  write_file(input, obj_file(mesh, {}));
  Context context;
  context.scratch = directory.path();
  RefinedShape out;
  out.report = simplify(context, input, output, fitted_where_asked(options));
  out.output = read_shape(output);
  out.defects = defects_of(out.output.faces);
  return out;
}

}  // namespace

TEST_CASE("a cube whose sides are fans with faces of no area becomes twelve faces", "[shapes]") {
  for (const std::size_t n : {3, 8, 40, 150}) {
    CAPTURE(n);
    check_cube(shapes::capped_cube(n));
  }
}

TEST_CASE("a cube with faces of no area along its edges becomes twelve faces", "[shapes]") {
  for (const std::size_t n : {1, 2, 8, 40, 150}) {
    CAPTURE(n);
    check_cube(shapes::cube_with_caps(n));
  }
}

TEST_CASE("faces have no area beside the digits that positions were written with", "[shapes]") {
  for (const double angle : {0.4, 1.1}) {
    for (const std::string format : {"%.7g", "%.8g", "%.9g", "%.12g", "%.14g", "%.9f"}) {
      // Of seven digits the cube itself is not one to more.
      const double bound = format == "%.7g" ? 1e-4 : 1e-5;
      for (const Shape& cube : {shapes::capped_cube(10), shapes::cube_with_caps(8)}) {
        CAPTURE(angle, format);
        const Shape shape = written(turned(cube, angle), format.c_str());
        const RefinedShape out = refine_shape(shape, {0, Numbers::doubles}, to_count(12));
        CHECK(out.output.faces.size() == 12);
        CHECK(is_closed(out));
        CHECK(std::abs(volume(out.output).value_or(0) - 1) < bound);
      }
    }
  }
}

TEST_CASE("whole numbers of a double are meant as they are", "[shapes]") {
  // Steps of one metre, far from the origin: no face of them is thin.
  Shape box = shapes::plate(12, 1);
  for (Point& p : box.vertices) {
    for (double& coordinate : p) coordinate = std::round(12 * coordinate);
    p = p + Point{500'000, 5'400'000, 0};
  }
  const RefinedShape out = refine_shape(box, {0, Numbers::doubles}, to_count(12));
  CHECK(out.output.faces.size() == 12);
  CHECK(volume(out.output).value_or(0) == Approx(12 * 12 * 12).epsilon(1e-9));
}

TEST_CASE("a square with a face of no area at its border becomes two faces", "[shapes]") {
  for_each_pose([](const Pose& pose) {
    const RefinedShape out =
        refine_shape(shapes::zero_area_border_square(), pose, to_relative_error(0.001));
    CHECK(out.output.faces.size() == 2);
    CHECK(std::abs(area(out.output) - 1) < 1e-6);
  });
}

TEST_CASE("a square with corners along its sides becomes two faces", "[shapes]") {
  for (const std::size_t points : {1, 3, 15, 100}) {
    CAPTURE(points);
    const Shape square = shapes::polygon_square(points);
    for_each_pose([&](const Pose& pose) {
      for (const std::uint64_t faces : {4, 6}) {
        CAPTURE(faces);
        const RefinedShape out = refine_shape(square, pose, to_count(faces));
        CHECK(out.output.faces.size() <= faces);
        CHECK(std::abs(area(out.output) - 1) < 1e-6);
      }
      const RefinedShape out = refine_shape(square, pose, to_relative_error(0.001));
      CHECK(out.output.faces.size() == 2);
      CHECK(std::abs(area(out.output) - 1) < 1e-6);
    });
    CHECK(std::abs(area(refine_polygon(square, to_count(4)).output) - 1) < 1e-6);
    const RefinedShape polygon = refine_polygon(square, to_relative_error(0.001));
    CHECK(polygon.output.faces.size() == 2);
    CHECK(std::abs(area(polygon.output) - 1) < 1e-6);
  }
}

}  // namespace winnow::test
