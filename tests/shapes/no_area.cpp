// Faces without area neither hinder nor cost anything.
#include "support/refined_shape.hpp"
#include "support/text_meshes.hpp"

#include <cmath>

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
  out.report = simplify(context, input, output, options);
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
