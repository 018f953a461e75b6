// Shapes whose distances are known exactly.
#include <winnow/compare.hpp>
#include <winnow/error.hpp>

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/stl_file.hpp"
#include "support/surfaces.hpp"

#include <numbers>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

using Faces = std::vector<Triangle>;

CompareReport compare_faces(const Faces& original, const Faces& simplified,
                            std::uint64_t samples = 20'000) {
  const Directory directory;
  write_file(directory.file("original.stl"), binary_stl(original));
  write_file(directory.file("simplified.stl"), binary_stl(simplified));
  Context context;
  context.threads = 2;
  context.scratch = directory.path();
  CompareOptions options;
  options.samples = samples;
  return compare(context, directory.file("original.stl"), directory.file("simplified.stl"),
                 options);
}

// A square in the plane z, of n * n * 2 faces that look up.
Faces square(double z, double side, int n = 8) {
  Faces faces;
  const double step = side / n;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Point a{i * step, j * step, z};
      const Point b{(i + 1) * step, j * step, z};
      const Point c{(i + 1) * step, (j + 1) * step, z};
      const Point d{i * step, (j + 1) * step, z};
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  }
  return faces;
}

Faces turned(Faces faces) {
  for (Triangle& face : faces) std::swap(face[1], face[2]);
  return faces;
}

void check_all(const Distances& distances, double expected) {
  CHECK(distances.mean == Approx(expected).margin(1e-12));
  CHECK(distances.rms == Approx(expected).margin(1e-12));
  CHECK(distances.max == Approx(expected).margin(1e-12));
}

}  // namespace

TEST_CASE("a mesh is at no distance from itself") {
  const Faces faces = ball(20, 0.2);
  const CompareReport report = compare_faces(faces, faces);
  for (const Distances& d : {report.forward, report.backward, report.symmetric})
    CHECK(d.max < 1e-7);
  CHECK(report.area_change == 0);
  REQUIRE(report.volume_change);
  CHECK(*report.volume_change == 0);
  CHECK(report.normal_deviation.mean < 0.2);  // samples on a side may find the neighbour
  CHECK(report.topology.flipped == 0);
  CHECK(report.topology.boundary_edges == 0);
  CHECK(report.topology.non_manifold_edges == 0);
  CHECK(report.topology.components == 1);
  CHECK(report.original.samples == Approx(20'000).epsilon(0.03));
  CHECK(report.original.samples == report.simplified.samples);
}

TEST_CASE("parallel squares are everywhere at their distance") {
  const CompareReport report = compare_faces(square(0, 4), square(0.25, 4, 1));
  check_all(report.forward, 0.25);
  check_all(report.backward, 0.25);
  check_all(report.symmetric, 0.25);
  CHECK(report.diagonal == Approx(std::sqrt(32.0)));
  CHECK(report.normal_deviation.mean == 0);
  CHECK_FALSE(report.original.volume);
  CHECK_FALSE(report.volume_change);
  CHECK(report.topology.boundary_edges == 4);
  CHECK(report.smallest_angles.min == Approx(45));
  CHECK(report.smallest_angles.mean == Approx(45));
}

TEST_CASE("the two directions differ where one mesh lacks a part") {
  // The right half is missing: its points are evenly 0 to 2 away.
  Faces half = square(0, 4);
  std::erase_if(half, [](const Triangle& t) { return t[0][0] + t[1][0] + t[2][0] > 6; });
  const CompareReport report = compare_faces(square(0, 4), half, 200'000);
  CHECK(report.forward.mean == Approx(0.5).epsilon(0.01));  // half at 0, half at 1 in the mean
  CHECK(report.forward.rms == Approx(std::sqrt(2.0 / 3)).epsilon(0.01));  // x^2 over 0..2, halved
  CHECK(report.forward.max == 2);
  check_all(report.backward, 0);
  CHECK(report.symmetric.max == 2);
  CHECK(report.symmetric.rms == Approx(report.forward.rms / std::sqrt(2.0)));
  CHECK(report.worst[0] == 4);
  CHECK(report.area_change == Approx(-0.5));
}

TEST_CASE("a ball in a ball") {
  Faces outer = ball(60);
  for (Triangle& face : outer) {
    for (Point& p : face) p = 1.5 * p;
  }
  const CompareReport report = compare_faces(ball(60), outer, 100'000);
  // Polyhedra of this fineness are within 0.002 of their balls.
  CHECK(report.forward.mean == Approx(0.5).margin(0.003));
  CHECK(report.backward.mean == Approx(0.5).margin(0.003));
  CHECK(report.symmetric.max == Approx(0.5).margin(0.003));
  CHECK(report.area_change == Approx(1.5 * 1.5 - 1).epsilon(0.001));
  REQUIRE(report.volume_change);
  CHECK(*report.volume_change == Approx(1.5 * 1.5 * 1.5 - 1).epsilon(0.001));
  CHECK(*report.original.volume == Approx(4 * std::numbers::pi / 3).epsilon(0.005));
  CHECK(report.normal_deviation.mean < 3);
}

TEST_CASE("what is far from the origin is measured as well") {
  Faces low = square(300, 4);
  Faces high = square(300.25, 4, 1);
  for (Faces* faces : {&low, &high}) {
    for (Triangle& face : *faces) {
      for (Point& p : face) p = p + Point{431000, 541200, 0};
    }
  }
  check_all(compare_faces(low, high).symmetric, 0.25);
}

TEST_CASE("any unit of length will do, and what no unit explains is refused") {
  for (const double unit : {1e-25, 1e19, 1e25}) {
    Faces low = square(0, 4);
    Faces high = square(0.25, 4, 1);
    for (Faces* faces : {&low, &high}) {
      for (Triangle& face : *faces) {
        for (Point& p : face) p = unit * p;
      }
    }
    const CompareReport report = compare_faces(low, high);
    CHECK(report.symmetric.max == Approx(0.25 * unit).epsilon(1e-6));
    CHECK(report.symmetric.rms == Approx(0.25 * unit).epsilon(1e-6));
    CHECK(report.original.samples == Approx(20'000).epsilon(0.03));
    // One face far away leaves the distances of the others as they are.
    low.push_back({Point{0, 0, 0}, {unit, 0, 0}, {0, 1e5 * unit, 1e5 * unit}});
    CHECK(compare_faces(high, low).forward.max == Approx(0.25 * unit).epsilon(1e-6));
  }
  const Faces huge{{Point{0, 0, 0}, {1e37, 0, 0}, {0, 1e37, 0}}};
  const Faces tiny{{Point{0, 0, 0}, {1e-37, 0, 0}, {0, 1e-37, 0}}};
  for (const Faces& faces : {huge, tiny}) {
    CHECK(error_of([&] { compare_faces(square(0, 1), faces); }).kind() == ErrorKind::bad_input);
    CHECK(error_of([&] { compare_faces(faces, square(0, 1)); }).kind() == ErrorKind::bad_input);
  }
}

TEST_CASE("faces that show their backs are flipped") {
  const Faces faces = square(0, 4, 4);
  Faces some = faces;
  for (std::size_t i = 0; i < 5; ++i) std::swap(some[i][1], some[i][2]);
  CHECK(compare_faces(faces, some).topology.flipped == 5);
  const CompareReport all = compare_faces(faces, turned(faces));
  CHECK(all.topology.flipped == faces.size());
  CHECK(all.normal_deviation.mean == 180);
  CHECK(all.normal_deviation.p95 >= 180);
  check_all(all.symmetric, 0);
}

TEST_CASE("what is wrong with the simplified mesh is counted") {
  Faces faces = square(0, 4, 2);                               // 8 faces
  faces.push_back({Point{0, 0, 0}, {2, 2, 0}, {2, 0, 0}});     // the first again, turned
  faces.push_back({Point{0, 0, 0}, {0, 0, 0}, {1, 0, 0}});     // a corner twice
  faces.push_back({Point{9, 0, 0}, {10, 0, 0}, {11, 0, 0}});   // no area
  faces.push_back({Point{20, 0, 0}, {21, 0, 0}, {20, 1, 0}});  // apart
  const CompareReport report = compare_faces(square(0, 4, 2), faces);
  CHECK(report.topology.duplicate == 1);
  CHECK(report.topology.degenerate == 2);
  CHECK(report.topology.components == 3);
  CHECK(report.simplified.bad_faces.degenerate == 1);
  // The doubled face has two sides inside, with three faces, and one on the boundary, with two; the
  // two lone faces have three boundary edges each.
  CHECK(report.topology.non_manifold_edges == 2);
  CHECK(report.topology.boundary_edges == 8 - 1 + 6);
}

TEST_CASE("what cannot be compared is refused") {
  const Directory directory;
  const std::string mesh = directory.file("mesh.stl");
  const std::string nothing = directory.file("nothing.stl");
  write_file(mesh, binary_stl(square(0, 1)));
  write_file(nothing, binary_stl({{Point{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}}));
  Context context;
  context.scratch = directory.path();
  const auto kind = [&](const std::string& original, const std::string& simplified) {
    return error_of([&] { compare(context, original, simplified, {}); }).kind();
  };
  CHECK(kind(nothing, mesh) == ErrorKind::bad_input);
  CHECK(kind(mesh, nothing) == ErrorKind::bad_input);
  CHECK(kind(mesh, directory.file("missing.stl")) == ErrorKind::bad_input);
  CHECK(kind("-", "-") == ErrorKind::usage);
  CompareOptions options;
  for (const std::uint64_t samples :
       {std::uint64_t{0}, std::uint64_t{99}, std::uint64_t{1} << 61}) {
    options.samples = samples;
    CHECK(error_of([&] { compare(context, mesh, mesh, options); }).kind() == ErrorKind::usage);
  }
  options = {};
  options.colored = directory.file("same");
  options.picture = directory.path() + "/./same";
  CHECK(error_of([&] { compare(context, mesh, mesh, options); }).kind() == ErrorKind::usage);
  // A file that cannot be written leaves nothing of the other.
  options.colored = "/dev/full";
  options.picture = directory.file("picture.png");
  CHECK(error_of([&] { compare(context, mesh, mesh, options); }).kind() == ErrorKind::resources);
  CHECK_FALSE(exists(options.picture));
  context.memory = std::uint64_t{20} << 20;
  const Error small = error_of([&] { compare(context, mesh, mesh, {}); });
  CHECK(small.kind() == ErrorKind::resources);
  CHECK(std::string(small.what()).find("`memory`") != std::string::npos);
}

}  // namespace winnow::test
