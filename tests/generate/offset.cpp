// A georeferenced surface is the same surface, moved, with nothing lost to rounding in single
// precision.
#include "surface_mesh.hpp"

#include <cstring>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("positions far from the origin are written in double") {
  GenerateOptions options = generate_options(Surface::scan, 20000);
  const SurfaceMesh mesh = mesh_of(options);
  options.offset = {5'000'000.25, -400'000.5, 0};
  const std::string bytes = generated(options);
  CHECK(bytes.find("property double x\n") != std::string::npos);
  const std::string end = "end_header\n";
  const std::size_t body = bytes.find(end) + end.size();
  bool exact = true;
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    Point point{};
    std::memcpy(point.data(), bytes.data() + body + k * sizeof point, sizeof point);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      exact = exact && point[axis] == mesh.points[k][axis] + options.offset[axis];
    }
  }
  CHECK(exact);
}

TEST_CASE("positions near the origin are written in single precision") {
  const std::string bytes = generated(generate_options(Surface::scan, 20000));
  CHECK(bytes.find("property float x\n") != std::string::npos);
}

TEST_CASE("an offset that single precision cannot follow is told") {
  const test::Directory directory;
  Context context;
  int notices = 0;
  context.notice = [&](const std::string&) { ++notices; };
  GenerateOptions options = generate_options(Surface::terrain, 2000);
  generate(context, directory.file("a.stl"), options);
  CHECK(notices == 0);
  options.offset = {5'000'000, 0, 0};
  generate(context, directory.file("a.ply"), options);
  CHECK(notices == 0);
  generate(context, directory.file("b.stl"), options);
  CHECK(notices == 1);
}

}  // namespace winnow
