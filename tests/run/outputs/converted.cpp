// A converted mesh is the mesh that was read: vertices and faces in their order, or welded where
// there are no vertices.
#include <winnow/convert.hpp>

#include "support/files.hpp"
#include "support/glb_file.hpp"
#include "support/job.hpp"
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/refining.hpp"
#include "support/stl_file.hpp"
#include "support/surfaces.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

ConvertReport convert_file(const Directory& directory, const std::string& from,
                           const std::string& to, ConvertOptions options = {}) {
  Context context;
  context.threads = 2;
  context.scratch = directory.path();
  options.force = true;
  return convert(context, from, to, options);
}

// Positions, and faces as numbers, of a binary PLY that winnow wrote.
struct Written {
  std::vector<Point> positions;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

Written written(const std::string& path) {
  const std::string file = bytes_of_file(path);
  TestJob test;
  const auto reader = open_reader(test.job, open_source(test.job, path), Format::automatic,
                                  Access::repeatedly, {usual_vertex_memory, 8192});
  Written out;
  out.positions = read_positions(test.job, *reader);
  const std::size_t count = *reader->facts().faces;
  REQUIRE(file.size() > 13 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const char* record = file.data() + file.size() - 13 * (count - i);
    REQUIRE(record[0] == 3);
    std::memcpy(out.faces.emplace_back().data(), record + 1, 12);
  }
  return out;
}

}  // namespace

TEST_CASE("vertices and faces of a PLY stay as they are in every format") {
  const Directory directory;
  Random random(700);
  Polygons mesh = random_polygons(random, 500, 900, 3);
  const std::string input = directory.file("in.ply");
  write_file(input, ply_file(mesh, {}));
  const ConvertReport report = convert_file(directory, input, directory.file("out.ply"));
  const Written out = written(directory.file("out.ply"));
  CHECK(out.positions == as_stored(mesh, {}).vertices);
  CHECK(report.input.faces == report.output.faces + report.input.bad_faces.total());
  CHECK_FALSE(report.welded);
  CHECK(report.doubled_faces == 0);
  std::vector<std::array<std::uint32_t, 3>> right;
  for (const auto& polygon : mesh.faces) {
    REQUIRE(polygon.size() == 3);
    const std::set<Point> places{out.positions[polygon[0]], out.positions[polygon[1]],
                                 out.positions[polygon[2]]};
    if (places.size() == 3)
      right.push_back({static_cast<std::uint32_t>(polygon[0]),
                       static_cast<std::uint32_t>(polygon[1]),
                       static_cast<std::uint32_t>(polygon[2])});
  }
  CHECK(out.faces == right);

  // By way of every other form.
  convert_file(directory, input, directory.file("out.glb"));
  const GlbFile glb = glb_file(bytes_of_file(directory.file("out.glb")));
  CHECK(glb.faces == right);
  for (const char* name : {"text.ply", "packed.ply.zst", "packed.ply.gz"}) {
    ConvertOptions options;
    options.encoding.ascii = std::string(name) == "text.ply";
    const std::string between = directory.file(name);
    convert_file(directory, input, between, options);
    convert_file(directory, between, directory.file("again.ply"));
    CHECK(bytes_of_file(directory.file("again.ply")) == bytes_of_file(directory.file("out.ply")));
  }
}

TEST_CASE("positions are converted between floats and doubles as asked for") {
  const Directory directory;
  Random random(701);
  PlyStyle style;
  style.coordinate = {PlyType::float64, PlyType::float64, PlyType::float64};
  const Polygons mesh = random_polygons(random, 100, 200, 3);
  write_file(directory.file("in.ply"), ply_file(mesh, style));
  ConvertOptions options;
  for (const auto& [positions, doubles] : {std::pair{Positions::as_input, true},
                                           {Positions::doubles, true},
                                           {Positions::floats, false}}) {
    options.encoding.positions = positions;
    convert_file(directory, directory.file("in.ply"), directory.file("out.ply"), options);
    CHECK(written(directory.file("out.ply")).positions ==
          as_stored(mesh, doubles ? style : PlyStyle{}).vertices);
  }
}

TEST_CASE("bad faces are left out, counted, or refused") {
  const Directory directory;
  Polygons mesh;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mesh.vertices = {{nan, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}, {1, 2, 3}, {1, 1, 2}, {1, 2, 9}, {3, 2, 1}};
  write_file(directory.file("in.ply"), ply_file(mesh, {}));
  const ConvertReport report =
      convert_file(directory, directory.file("in.ply"), directory.file("out.ply"));
  CHECK(report.input.bad_faces.non_finite == 1);
  CHECK(report.input.bad_faces.degenerate == 1);
  CHECK(report.input.bad_faces.out_of_range == 1);
  const Written out = written(directory.file("out.ply"));
  CHECK(out.faces == std::vector<std::array<std::uint32_t, 3>>{{1, 2, 3}, {3, 2, 1}});
  // Numbers stay what they were.
  CHECK(out.positions == std::vector<Point>{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(report.notes.size() == 1);

  ConvertOptions strict;
  strict.strict = true;
  CHECK(error_of([&] {
          convert_file(directory, directory.file("in.ply"), directory.file("strict.ply"), strict);
        }).kind() == ErrorKind::bad_input);
  CHECK_FALSE(exists(directory.file("strict.ply")));
}

TEST_CASE("equal positions of an STL become one vertex, and its faces stay") {
  const Directory directory;
  const std::vector<Triangle> faces = as_floats(ball(20, 0.1));
  write_file(directory.file("in.stl"), binary_stl(faces));
  const ConvertReport report =
      convert_file(directory, directory.file("in.stl"), directory.file("out.ply"));
  CHECK(report.welded);
  CHECK(report.output.faces == faces.size());
  CHECK(report.output.vertices == faces.size() / 2 + 2);  // Euler: it is closed
  const Written out = written(directory.file("out.ply"));
  CHECK(std::set<Point>(out.positions.begin(), out.positions.end()).size() == out.positions.size());
  // Turned so that the lowest corner comes first, the triangles are the same.
  const auto turned_to_lowest = [](Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  std::multiset<Triangle> right;
  std::multiset<Triangle> found;
  for (const Triangle& face : faces) right.insert(turned_to_lowest(face));
  for (const auto& f : out.faces)
    found.insert(turned_to_lowest({out.positions[f[0]], out.positions[f[1]], out.positions[f[2]]}));
  CHECK(found == right);

  // A second time there is nothing left to weld.
  convert_file(directory, directory.file("out.ply"), directory.file("back.stl"));
  convert_file(directory, directory.file("back.stl"), directory.file("again.ply"));
  CHECK(bytes_of_file(directory.file("again.ply")) == bytes_of_file(directory.file("out.ply")));
}

TEST_CASE("an input without a good face is no mesh to write") {
  const Directory directory;
  Polygons mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}};
  mesh.faces = {{0, 1, 1}};
  write_file(directory.file("in.ply"), ply_file(mesh, {}));
  CHECK(error_of([&] {
          convert_file(directory, directory.file("in.ply"), directory.file("out.ply"));
        }).kind() == ErrorKind::bad_input);
  CHECK_FALSE(exists(directory.file("out.ply")));
}

}  // namespace winnow::test
