// Triangle strips.
#include "support/ply_file.hpp"
#include "support/reading.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;

namespace {

test::PlyStyle strip_style(PlyForm form, PlyType index) {
  test::PlyStyle style;
  style.form = form;
  style.count = PlyType::int32;
  style.index = index;
  style.faces = "tristrips";
  return style;
}

}  // namespace

TEST_CASE("every second triangle of a strip is mirrored, so that all face one way") {
  test::Polygons mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
  mesh.faces = {{0, 1, 2, 3, 4}};
  const std::vector<test::SeenFace> seen =
      test::faces_of(ply_file(mesh, strip_style(PlyForm::little_endian, PlyType::int32)));
  REQUIRE(seen.size() == 3);
  for (const test::SeenFace& face : seen) {
    const auto& [a, b, c] = face.corner;
    CHECK((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0);
  }
}

TEST_CASE("strips with restarts and turns are read as their definition says") {
  test::Random random(230);
  for (int round = 0; round < 60; ++round) {
    test::Polygons mesh = test::random_polygons(random, 100, 0, 3);
    for (std::size_t strips = random.between(1, 4); strips > 0; --strips) {
      std::vector<std::int64_t> strip(random.below(2000));
      for (std::int64_t& index : strip) {
        index = static_cast<std::int64_t>(random.below(100));
        if (random.chance(0.05)) index = -1;
      }
      // A repeated index turns the strip around a corner.
      for (std::size_t i = 1; i < strip.size(); ++i) {
        if (random.chance(0.1)) strip[i] = strip[i - 1];
      }
      mesh.faces.push_back(strip);
    }
    for (int form = 0; form < 3; ++form) {
      for (const PlyType index : {PlyType::int8, PlyType::int16, PlyType::int32}) {
        test::PlyStyle style = strip_style(static_cast<PlyForm>(form), index);
        style.faces_first = random.chance(0.3);
        if (random.chance(0.5)) style.ornaments = &random;
        const test::ReadStyle reading{
            Format::automatic,
            Access::once,
            {test::usual_vertex_memory, random.one_of<std::size_t>({5, 64, 8192})}};
        const std::string file = ply_file(mesh, style);
        CAPTURE(round, form, static_cast<int>(index));
        REQUIRE(difference(test::faces_of(file, reading), as_strips(as_stored(mesh, style))) == "");
        REQUIRE(difference(test::faces_of_pipe(file, reading), as_strips(as_stored(mesh, style))) ==
                "");
      }
    }
  }
}

TEST_CASE("an index of a strip that names no vertex spoils its triangles only") {
  test::Polygons mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.faces = {{0, 1, 2, 77, 3, 1, 0, 2}, {0, 1, -7, 2, 3, 1}};
  CHECK(difference(
            test::faces_of(ply_file(mesh, strip_style(PlyForm::little_endian, PlyType::int32))),
            as_strips(mesh)) == "");
}

TEST_CASE("faces and strips in one file: the faces count, strips only where there are none") {
  std::string file =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 0\n"
      "property list uchar int vertex_indices\nelement tristrips 1\nproperty list int int "
      "vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n";
  CHECK(test::faces_of(file).size() == 2);
  file.replace(file.find("element face 0"), 14, "element face 1");
  file.insert(file.find("4 0 1 2 3"), "3 0 1 2\n");
  CHECK(test::faces_of(file).size() == 1);
}

}  // namespace winnow
