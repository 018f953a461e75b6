// Faces that cannot take part: each kind is told apart and counted, in every form of file.
#include "cluster/clusterer.hpp"
#include "cluster/resolution.hpp"
#include "io/arena.hpp"
#include "read/for_each_batch.hpp"
#include "support/not_finite.hpp"
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/stl_file.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

ClusterCounts counts_of(const std::string& file, double cell = 0.5) {
  test::TestJob test;
  const auto reader =
      open_reader(test.job, std::make_unique<test::MemorySource>(file), Format::automatic,
                  Access::repeatedly, {test::usual_vertex_memory, 512});
  return in_arena(test.job, [&] {
    const Box box = measure_box(test.job, *reader);
    const auto clusterer = Clusterer::make(test.job, {Grid::over(box, cell), Placement::mean, true},
                                           {1 << 22, 1 << 22, 1 << 22, 1 << 22, 16});
    reader->begin_faces();
    for_each_face_batch(test.job, *reader, [&](const FaceBatch& faces) { clusterer->add(faces); },
                        {});
    return clusterer->counts();
  });
}

void check_counts(const ClusterCounts& counts, std::uint64_t faces, const BadFaces& bad) {
  CHECK(counts.faces == faces);
  CHECK(counts.bad.degenerate == bad.degenerate);
  CHECK(counts.bad.non_finite == bad.non_finite);
  CHECK(counts.bad.out_of_range == bad.out_of_range);
  CHECK(counts.outside == 0);
}

template <typename Check>
void in_every_form(Check check) {
  for (int form = 0; form < 3; ++form) {
    for (const bool faces_first : {false, true}) {
      for (const PlyType index : {PlyType::int32, PlyType::uint32, PlyType::int16}) {
        test::PlyStyle style;
        style.form = static_cast<PlyForm>(form);
        style.index = index;
        style.faces_first = faces_first;
        style.coordinate.fill(PlyType::float64);
        CAPTURE(form, faces_first, static_cast<int>(index));
        check(style);
      }
    }
  }
}

const std::vector<test::Point> corners_of_square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};

}  // namespace

TEST_CASE("indices of no vertex are out of range, negative ones too") {
  in_every_form([](test::PlyStyle style) {
    test::Polygons mesh{
        corners_of_square,
        {{0, 1, 2}, {0, 1, 4}, {5, 6, 7}, {0, 30000, 2}, {1, 2, 3}, {0, 1, 2, 4}, {3, 2, 1}}};
    std::uint64_t more = 0;
    if (style.index != PlyType::uint32) {
      mesh.faces.push_back({0, -1, 2});
      mesh.faces.push_back({-30000, 1, 2});
      more = 2;
    }
    // A polygon's triangles are told apart: of {0, 1, 2, 4} the first is good.
    check_counts(counts_of(ply_file(mesh, style)), 8 + more, {0, 0, 4 + more});
    CHECK(test::difference(test::faces_of(ply_file(mesh, style)), as_triangles(mesh)) == "");
  });
}

TEST_CASE("the highest index of 32 bits is out of range, not minus one") {
  test::PlyStyle style;
  style.index = PlyType::uint32;
  const test::Polygons mesh{corners_of_square, {{0, 1, 2}, {0, 1, 4294967295}, {0, 2147483648, 2}}};
  for (int form = 0; form < 3; ++form) {
    style.form = static_cast<PlyForm>(form);
    check_counts(counts_of(ply_file(mesh, style)), 3, {0, 0, 2});
  }
}

TEST_CASE("corners that are not finite are told, whatever else the vertex list holds") {
  std::vector<test::Point> vertices = corners_of_square;
  for (const double bad : {test::nan, test::infinity, -test::infinity}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vertices.push_back({0, 0, 0});
      vertices.back()[axis] = bad;
    }
  }
  test::Polygons mesh{vertices, {{0, 1, 2}, {1, 3, 2}}};
  for (std::int64_t i = 4; i < 13; ++i) mesh.faces.push_back({0, 1, i});
  in_every_form([&](const test::PlyStyle& style) {
    check_counts(counts_of(ply_file(mesh, style)), 11, {0, 9, 0});
  });
}

TEST_CASE("repeated corners are degenerate, by index and by position") {
  std::vector<test::Point> vertices = corners_of_square;
  vertices.push_back({1, 0, -0.0});  // the second vertex again: minus nothing is nothing
  const test::Polygons mesh{
      vertices, {{0, 1, 2}, {0, 0, 1}, {1, 2, 1}, {2, 3, 3}, {1, 4, 0}, {2, 1, 4}, {0, 4, 2}}};
  in_every_form([&](const test::PlyStyle& style) {
    check_counts(counts_of(ply_file(mesh, style)), 7, {5, 0, 0});
  });
}

TEST_CASE("a face of two corners is degenerate, whatever its vertices are") {
  // The first vertex of the file is no number, and there may be none at all.
  const test::Polygons odd{{{test::nan, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                           {{1, 2, 3}, {1, 2}, {}, {0}}};
  const test::Polygons none{{}, {{0, 1}, {}}};
  in_every_form([&](const test::PlyStyle& style) {
    check_counts(counts_of(ply_file(odd, style)), 4, {3, 0, 0});
    for (const test::SeenFace& face : test::faces_of(ply_file(none, style)))
      CHECK(face.status == FaceStatus::degenerate);
  });
}

TEST_CASE("zero area alone is not bad") {
  const test::Polygons mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 5, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  in_every_form([&](const test::PlyStyle& style) {
    check_counts(counts_of(ply_file(mesh, style)), 2, {0, 0, 0});
  });
}

TEST_CASE("bad faces of an STL are told apart as those of a PLY") {
  std::vector<test::Triangle> faces{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                    {{{0, 0, 0}, {1, 0, 0}, {0, test::nan, 0}}},
                                    {{{0, 0, -test::infinity}, {1, 0, 0}, {0, 1, 0}}},
                                    {{{1, 1, 1}, {1, 1, 1}, {0, 1, 0}}},
                                    {{{0, 0, 0}, {1, 0, 0}, {1, 0, -0.0}}}};
  for (const std::string& file : {test::binary_stl(faces), test::ascii_stl(faces)})
    check_counts(counts_of(file), 5, {2, 2, 0});
}

TEST_CASE("the first bad face is remembered with what is wrong") {
  test::Random random(260);
  for (int round = 0; round < 20; ++round) {
    test::Polygons mesh{corners_of_square, {}};
    mesh.faces.assign(3000, {0, 1, 2});
    const std::size_t bad = random.below(2500);
    mesh.faces[bad] = {0, 1, 9};
    for (int i = 0; i < 5; ++i) mesh.faces[random.between(bad + 1, 2999)] = {0, 0, 1};
    const ClusterCounts counts = counts_of(ply_file(mesh, {}));
    CHECK(counts.first_bad.face == bad);
    CHECK(std::string(counts.first_bad.what).find("vertex") != std::string::npos);
  }
  CHECK(counts_of(test::ply_file({corners_of_square, {{0, 1, 2}}}, {})).first_bad.face ==
        UINT64_MAX);
}

TEST_CASE("a face that is left out is not counted as too large either") {
  // What takes the place of its missing corner may be anywhere.
  const test::Polygons mesh{{{1000, 1000, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                            {{1, 2, 3}, {1, 2, 77}}};
  test::PlyStyle style;
  CHECK(counts_of(ply_file(mesh, style), 0.5).clamped == 0);
  const test::Polygons large{{{1000, 1000, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                             {{1, 2, 3}, {0, 1, 2}}};
  CHECK(counts_of(ply_file(large, style), 0.5).clamped == 1);
}

}  // namespace winnow
