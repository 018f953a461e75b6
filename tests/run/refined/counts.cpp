// The count that was asked for: exactly, and where the surface does not allow it, that is said.
#include <winnow/error.hpp>

#include "support/files.hpp"
#include "support/ply_file.hpp"
#include "support/program.hpp"
#include "support/refined_file.hpp"

#include <cmath>
#include <cstdio>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// Four faces each, none of which can go.
std::vector<Triangle> tetrahedra(std::size_t count) {
  Random random(900);
  std::vector<Triangle> faces;
  for (std::size_t i = 0; i < count; ++i) {
    const Point at{random.unit(), random.unit(), random.unit()};
    const std::array<Point, 4> p{at, at + Point{0.02, 0, 0}, at + Point{0, 0.02, 0},
                                 at + Point{0, 0, 0.02}};
    for (const Triangle& face :
         {Triangle{p[0], p[2], p[1]}, {p[0], p[1], p[3]}, {p[1], p[2], p[3]}, {p[2], p[0], p[3]}})
      faces.push_back(face);
  }
  return faces;
}

}  // namespace

TEST_CASE("a closed mesh gets the count or one less where that is odd", "[long]") {
  const Directory directory;
  for (const std::uint64_t wanted : {50'000, 10'001, 999, 100}) {
    const RefinedFile out = refine_file(directory, whale(), to_faces(wanted));
    CAPTURE(wanted);
    CHECK(out.report.target_faces == wanted);
    CHECK(out.report.output.faces == wanted / 2 * 2);
    CHECK(out.mesh.faces.size() == out.report.output.faces);
    CHECK(out.mesh.vertices.size() == out.report.output.vertices);
    CHECK(out.report.refine.stopped_by == StoppedBy::count);
    CHECK(out.report.refine.cost == Refine::quadric);
    CHECK(out.report.refine.collapses == (100'000 - wanted / 2 * 2) / 2);
    // Of the least count, that more than a hundredth of the area went.
    CHECK(out.report.notes.size() == (wanted == 100 ? 1 : 0));
    const Defects defects = defects_of(out.mesh.faces);
    CHECK(defects.boundary_edges + defects.crowded + defects.discords + defects.duplicates == 0);
  }
}

TEST_CASE("a closed mesh without handles becomes a tetrahedron, one with handles keeps them") {
  const Directory directory;
  const std::string scan = directory.file("scan.ply");
  generate("scan", 20'000, scan);
  for (const std::uint64_t wanted : {5, 4}) {
    const RefinedFile out = refine_file(directory, scan, to_faces(wanted));
    CHECK(out.report.output.faces == 4);
    CHECK(out.report.refine.stopped_by == StoppedBy::count);
  }
  const RefinedFile cranium = refine_file(directory, whale(), to_faces(4));
  CHECK(cranium.report.output.faces > 4);
  CHECK(cranium.report.refine.stopped_by == StoppedBy::topology);
  CHECK(cranium.report.notes.size() == 2);  // the area that went, and why the count was missed
  const auto characteristic = [](const PlainMesh& mesh) {
    // Closed: three edges for every two faces.
    return static_cast<std::int64_t>(mesh.vertices.size()) -
           static_cast<std::int64_t>(mesh.faces.size() / 2);
  };
  TestJob test;
  CHECK(characteristic(cranium.mesh) == characteristic(plain(welded(test.job, whale()))));
}

TEST_CASE("a mesh with a border gets the count") {
  const Directory directory;
  for (const std::uint64_t wanted : {20'001, 20'000, 777}) {
    const RefinedFile out = refine_file(directory, mountains(), to_faces(wanted));
    CAPTURE(wanted);
    CHECK(out.report.output.faces <= wanted);
    CHECK(out.report.output.faces + 1 >= wanted);
    CHECK(defects_of(out.mesh.faces).crowded == 0);
  }
}

TEST_CASE("a ratio is a count") {
  const Directory directory;
  SimplifyOptions options;
  options.target = Target::ratio(0.0321);
  const RefinedFile out = refine_file(directory, whale(), options);
  CHECK(out.report.target_faces == 3210);
  CHECK(out.report.output.faces == 3210);
}

TEST_CASE("a ratio is one of triangles, of a file of other polygons too") {
  const Directory directory;
  constexpr std::int64_t side = 40;
  Polygons quads;
  for (std::int64_t i = 0; i <= side; ++i) {
    for (std::int64_t j = 0; j <= side; ++j) {
      const auto x = static_cast<double>(i);
      const auto y = static_cast<double>(j);
      quads.vertices.push_back({x, y, std::sin(x / 5) * std::cos(y / 7)});
      const std::int64_t v = i * (side + 1) + j;
      if (i < side && j < side) quads.faces.push_back({v, v + side + 1, v + side + 2, v + 1});
    }
  }
  SimplifyOptions options;
  options.target = Target::ratio(0.5);
  for (const PlyForm form : {PlyForm::ascii, PlyForm::little_endian}) {
    PlyStyle style;
    style.form = form;
    const std::string path = directory.file("quads.ply");
    write_file(path, ply_file(quads, style));
    const RefinedFile out = refine_file(directory, path, options);
    CHECK(out.report.target_faces == side * side);
    CHECK(out.report.input.faces == 2 * side * side);
    Context context;
    context.scratch = directory.path();
    const std::string both = directory.file("both.ply");
    CHECK(simplify(context, std::vector{path, path}, both, options).target_faces ==
          2 * side * side);
    std::remove(both.c_str());
  }
}

TEST_CASE("clustering first changes nothing about the count") {
  const Directory directory;
  for (const double detail : {1.5, 3.0, 10.0}) {
    SimplifyOptions options = to_faces(3001);
    options.detail = detail;
    const RefinedFile out = refine_file(directory, whale(), options);
    CAPTURE(detail);
    // Where cells are larger than the skull's walls are thick, all faces are refined, and a note
    // says so.
    CHECK((out.report.cell_size > 0) == out.report.notes.empty());
    CHECK((out.report.cell_size > 0 || detail < 10));
    CHECK(out.report.output.faces == 3000);
    CHECK(defects_of(out.mesh.faces).duplicates == 0);
  }
}

TEST_CASE("below what kept pieces allow the fewest faces are left and it is said") {
  const Directory directory;
  SimplifyOptions options = to_faces(10);
  const RefinedFile out = refine_faces(directory, tetrahedra(50), options);
  CHECK(out.report.output.faces == 8);
  CHECK(out.report.target_met == true);
  CHECK(out.report.lost.pieces == 48);
  options.keep_pieces = true;
  const RefinedFile kept = refine_faces(directory, tetrahedra(50), options);
  CHECK(kept.report.output.faces == 200);
  CHECK(kept.report.refine.stopped_by == StoppedBy::pieces);
  CHECK(kept.report.target_met == false);
  CHECK(kept.report.missed_by == std::vector{StoppedBy::pieces});
  CHECK(kept.report.lost.pieces == 0);
  REQUIRE(kept.report.notes.size() == 1);
  CHECK(kept.report.notes[0].find("200 faces are left instead of 10: `keep_pieces`") !=
        std::string::npos);
}

TEST_CASE("more faces than there are leaves all of them, with normals and without lone vertices") {
  const Directory directory;
  SimplifyOptions options = to_faces(1'000'000);
  options.normals = true;
  const std::vector<Triangle> faces = as_floats(ball(20));
  const RefinedFile out = refine_faces(directory, faces, options);
  CHECK(out.report.output.faces == faces.size());
  CHECK(out.report.refine.collapses == 0);
  CHECK(out.report.refine.stopped_by == StoppedBy::count);
  // As a PLY, with vertices that no face uses: those go.
  const std::string ply = directory.file("lone.ply");
  write_file(ply,
             "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float "
             "y\nproperty float z\n"
             "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
             "9 9 9\n0 0 0\n1 0 0\n0 1 0\n7 7 7\n3 1 2 3\n");
  const RefinedFile lone = refine_file(directory, ply, options);
  CHECK(lone.report.output.faces == 1);
  CHECK(lone.report.output.vertices == 3);
  const std::string bytes = bytes_of_file(lone.path);
  std::array<float, 6> vertex{};
  std::memcpy(vertex.data(), bytes.data() + bytes.find("end_header\n") + 11, sizeof vertex);
  CHECK(vertex[5] == 1);  // the normal of a face in the plane z = 0
}

TEST_CASE("a soup of any faces is refined without new faults") {
  Random random(901);
  const Directory directory;
  // Corners on a coarse lattice: edges with many faces, fans that meet in a point, faces in one
  // another.
  std::vector<Triangle> faces = soup(random, 8000, 0.4);
  for (Triangle& face : faces) {
    for (Point& corner : face) {
      for (double& x : corner) x = std::round(x * 7) / 7;
    }
  }
  const RefinedFile all = refine_faces(directory, faces, to_faces(1'000'000));
  const Defects before = defects_of(all.mesh.faces);
  CHECK(before.crowded > 1000);
  for (const std::uint64_t wanted : {all.report.output.faces - 100, all.report.output.faces / 2}) {
    const RefinedFile out = refine_faces(directory, faces, to_faces(wanted));
    CHECK(
        (out.report.output.faces <= wanted || out.report.refine.stopped_by == StoppedBy::topology));
    const Defects after = defects_of(out.mesh.faces);
    CHECK(after.crowded <= before.crowded);
    CHECK(after.duplicates == 0);
    CHECK(after.degenerate == 0);
  }
}

TEST_CASE("within an error the faces without neighbours go that are smaller than it") {
  const Directory directory;
  Random random(902);
  const std::string input = directory.file("in.stl");
  const std::vector<Triangle> faces = as_floats(soup(random, 100, 0.01));
  write_file(input, binary_stl(faces));
  for (const double error : {1e-4, 0.004, 1000.0}) {
    CAPTURE(error);
    SimplifyOptions options;
    options.target = Target::error(error);
    const auto stays = [error](const Triangle& face) {
      const Box box = box_of({face});
      return box.longest_side() >= error;
    };
    const auto left = static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), stays));
    // One is left in any case.
    CHECK(refine_file(directory, input, options).mesh.faces.size() ==
          std::max<std::size_t>(1, left));
  }
}

}  // namespace winnow::test
