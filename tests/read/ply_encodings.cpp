// Every way to write a mesh as PLY gives the same faces.
#include "support/files.hpp"
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;

TEST_CASE("every count and index type in every form gives the same faces") {
  test::Random random(210);
  const test::Polygons mesh = test::random_polygons(random, 100, 60, 6);
  for (int form = 0; form < 3; ++form) {
    for (std::size_t count = 0; count < test::whole_types; ++count) {
      for (std::size_t index = 0; index < test::whole_types; ++index) {
        test::PlyStyle style;
        style.form = static_cast<PlyForm>(form);
        style.count = test::ply_types.at(count);
        style.index = test::ply_types.at(index);
        const std::vector<test::SeenFace> right = as_triangles(as_stored(mesh, style));
        for (const char* list : {"vertex_index", "vertex_indices"}) {
          style.list = list;
          style.new_names = !style.new_names;
          const std::string file = ply_file(mesh, style);
          CAPTURE(form, count, index, list);
          REQUIRE(difference(test::faces_of(file), right) == "");
          REQUIRE(difference(test::faces_of_pipe(file), right) == "");
        }
      }
    }
  }
}

TEST_CASE("every coordinate type in every form gives the same positions") {
  test::Random random(211);
  const test::Polygons mesh = test::random_polygons(random, 100, 60, 4);
  for (int form = 0; form < 3; ++form) {
    for (const PlyType type : test::ply_types) {
      test::PlyStyle style;
      style.form = static_cast<PlyForm>(form);
      style.coordinate.fill(type);
      test::Polygons positive = mesh;
      for (test::Point& p : positive.vertices) {
        for (double& x : p) x = std::abs(x);  // some types are unsigned
      }
      const std::string file = ply_file(positive, style);
      const std::vector<test::SeenFace> right = as_triangles(as_stored(positive, style));
      CAPTURE(form, test::type_name(type, true));
      REQUIRE(difference(test::faces_of(file), right) == "");
      REQUIRE(difference(test::faces_of_pipe(file), right) == "");
    }
  }
}

TEST_CASE("coordinates of different types each keep their own precision in every form") {
  test::Random random(212);
  const test::Polygons mesh = test::random_polygons(random, 100, 60, 3);
  for (int form = 0; form < 3; ++form) {
    test::PlyStyle style;
    style.form = static_cast<PlyForm>(form);
    style.coordinate = {PlyType::float32, PlyType::float64, PlyType::int16};
    const std::string file = ply_file(mesh, style);
    CAPTURE(form);
    CHECK(difference(test::faces_of(file), as_triangles(as_stored(mesh, style))) == "");
    CHECK(difference(test::faces_of_pipe(file), as_triangles(as_stored(mesh, style))) == "");
  }
}

TEST_CASE("random meshes in random styles are read as they were written") {
  test::Random random(213);
  for (int round = 0; round < 400; ++round) {
    const std::size_t vertices = random.between(1, random.one_of<std::uint64_t>({10, 120, 3000}));
    test::Polygons mesh =
        test::random_polygons(random, vertices, random.between(0, random.chance(0.1) ? 4000 : 300),
                              random.chance(0.5) ? 3 : 9);
    test::PlyStyle style = random_ply_style(random, mesh);
    if (style.coordinate[0] == PlyType::int32) {
      for (test::Point& p : mesh.vertices) p[0] *= 1e6;  // beyond a float
    }
    // In ASCII next to a double, a float would keep the digits of its text: another test.
    if (style.form == PlyForm::ascii) style.coordinate.fill(style.coordinate[0]);
    const std::string file = ply_file(mesh, style);
    const std::vector<test::SeenFace> right = as_triangles(as_stored(mesh, style));
    const test::ReadStyle reading{
        Format::automatic,
        Access::once,
        {test::usual_vertex_memory, random.one_of<std::size_t>({8, 100, 700, 8192})}};
    CAPTURE(round, file.substr(0, file.find("end_header")));
    REQUIRE(difference(test::faces_of(file, reading), right) == "");
    REQUIRE(difference(test::faces_of_pipe(file, reading), right) == "");
  }
}

TEST_CASE("an element of faces may stand before the vertices") {
  test::Random random(214);
  for (int form = 0; form < 3; ++form) {
    for (const std::size_t faces : {std::size_t{0}, std::size_t{3}, std::size_t{20'000}}) {
      const test::Polygons mesh = test::random_polygons(random, 500, faces, 5);
      test::PlyStyle style;
      style.form = static_cast<PlyForm>(form);
      style.faces_first = true;
      const std::string file = ply_file(mesh, style);
      CAPTURE(form, faces);
      CHECK(difference(test::faces_of(file), as_triangles(as_stored(mesh, style))) == "");
      // No memory for faces: they wait in scratch.
      CHECK(difference(test::faces_of_pipe(file, {Format::automatic, Access::once, {0, 512}}),
                       as_triangles(as_stored(mesh, style))) == "");
    }
  }
}

TEST_CASE("the header tells what is in the file") {
  test::Random random(215);
  const test::Polygons mesh = test::random_polygons(random, 10, 7, 3);
  for (int form = 0; form < 3; ++form) {
    for (const PlyType type : {PlyType::float32, PlyType::float64}) {
      test::PlyStyle style;
      style.form = static_cast<PlyForm>(form);
      style.coordinate[2] = type;
      test::TestJob test;
      const auto reader =
          open_reader(test.job, std::make_unique<test::MemorySource>(ply_file(mesh, style)),
                      Format::automatic, Access::once, {1 << 20, 100});
      CHECK(reader->facts().faces == 7);
      CHECK(reader->facts().vertices == 10);
      CHECK(reader->facts().double_positions == (type == PlyType::float64));
      CHECK_FALSE(reader->facts().normals);
      constexpr std::array forms{"PLY ASCII", "PLY binary little-endian", "PLY binary big-endian"};
      CHECK(reader->facts().format == forms.at(static_cast<std::size_t>(form)));
      CHECK(reader->name() == "test");
    }
  }
}

}  // namespace winnow
