// Clustering comes first where there are many faces. It keeps what the surface is, as full detail
// does.
#include "support/program.hpp"
#include "support/random.hpp"
#include "support/refined_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace winnow::test {

namespace {

struct Both {
  RefinedShape clustered, full;
};

// To a count, clustered first and with full detail.
Both refine_both(const Shape& shape, const Pose& pose, SimplifyOptions options) {
  Both both;
  options.detail = 6;
  both.clustered = refine_shape(shape, pose, options);
  options.detail = std::numeric_limits<double>::infinity();
  both.full = refine_shape(shape, pose, options);
  return both;
}

void check_same_size(const Both& both) {
  CHECK(both.clustered.output.faces.size() == Approx(both.full.output.faces.size()).margin(2));
  CHECK(area(both.clustered.output) == Approx(area(both.full.output)).epsilon(0.01));
}

void check_closed_alike(const Shape& shape, std::uint64_t faces, bool clusters = true) {
  for (const Pose& pose : {Pose{0, Numbers::floats}, Pose{0.4, Numbers::doubles}}) {
    CAPTURE(faces, pose.angle);
    const Both both = refine_both(shape, pose, to_count(faces));
    CHECK(both.full.report.cell_size == 0);
    if (clusters) {
      CHECK(both.clustered.report.cell_size > 0);
      CHECK(both.clustered.report.split_cells > 0);
    }
    CHECK(both.clustered.output.faces.size() <= faces);
    CHECK(is_closed(both.clustered));
    check_same_size(both);
    REQUIRE(volume(both.clustered.output));
    CHECK(*volume(both.clustered.output) == Approx(*volume(both.full.output)).epsilon(0.01));
  }
}

// A sheet, and fins that stand on a line of its edges.
Shape sheet_with_fins(std::size_t n) {
  Shape shape = shapes::hills(n, 0.1);
  const auto row = static_cast<std::uint32_t>(n + 1);
  const auto first = static_cast<std::uint32_t>(n / 2 * row);
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto tip = static_cast<std::uint32_t>(shape.vertices.size());
    shape.vertices.push_back(shape.vertices[first + i] + Point{0, 0, 0.2});
    shape.faces.push_back({first + i, first + i + 1, tip});
  }
  return shape;
}

// With holes of one face and of a few.
Shape pierced(Shape shape) {
  const std::size_t faces = shape.faces.size();
  for (const std::size_t at : {faces / 3, faces / 2, faces / 2 + 1, faces / 2 + 2, 4 * faces / 5})
    shape.faces[at] = shape.faces.back();
  std::sort(shape.faces.begin(), shape.faces.end());
  shape.faces.erase(std::unique(shape.faces.begin(), shape.faces.end()), shape.faces.end());
  return shape;
}

std::set<Point> border_vertices(const Shape& shape) {
  std::set<Point> vertices;
  for (const Segment& edge : border_of(shape)) vertices.insert(edge.begin(), edge.end());
  return vertices;
}

// Closed pieces over the unit square.
Shape dust(std::size_t pieces, double size, std::uint64_t seed) {
  Random random(seed);
  Shape shape;
  for (std::size_t i = 0; i < pieces; ++i) {
    const auto first = static_cast<std::uint32_t>(shape.vertices.size());
    const Point at{random.unit(), random.unit(), 1 + random.unit()};
    for (const Point& p : {Point{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
      shape.vertices.push_back(at + size * p);
    for (const auto& [a, b, c] : {std::array{0U, 2U, 1U}, {0U, 1U, 3U}, {0U, 3U, 2U}, {1U, 2U, 3U}})
      shape.faces.push_back({first + a, first + b, first + c});
  }
  return shape;
}

}  // namespace

TEST_CASE("a scan that is clustered first stays closed", "[shapes]") {
  const Directory directory;
  for (const std::uint64_t faces : {300'000, 700'000}) {
    const std::string input = directory.file("scan.ply");
    generate("scan", faces, input);
    const Shape scan = read_shape(input);
    ::unlink(input.c_str());
    for (const std::uint64_t wanted : {faces / 100, faces / 40}) check_closed_alike(scan, wanted);
  }
}

TEST_CASE("thin walls that are clustered first stay two", "[shapes]") {
  check_closed_alike(shapes::thin_shell(100, 0.005), 3000, false);
  check_closed_alike(shapes::thin_shell(100, 0.02), 6000, false);
  check_closed_alike(shapes::plate(80, 0.001), 500, false);
}

TEST_CASE("boundaries hardly shrink where faces are clustered first", "[shapes]") {
  for (const std::uint64_t wanted : {200, 1000, 4000}) {
    CAPTURE(wanted);
    const Both both = refine_both(shapes::hills(260), {}, to_count(wanted));
    CHECK(both.clustered.report.cell_size > 0);
    CHECK(both.clustered.defects.crowded == 0);
    CHECK(both.clustered.defects.discords == 0);
    check_same_size(both);
    // One boundary, as long as before.
    double border = 0;
    for (const Segment& edge : border_of(both.clustered.output))
      border += length(edge[1] - edge[0]);
    double full = 0;
    for (const Segment& edge : border_of(both.full.output)) full += length(edge[1] - edge[0]);
    CHECK(border == Approx(full).epsilon(0.02));
  }
}

TEST_CASE("kept boundaries keep every vertex whatever is clustered", "[shapes]") {
  for (const Pose& pose : {Pose{0, Numbers::floats}, Pose{0.4, Numbers::doubles}}) {
    for (const bool with_holes : {false, true}) {
      CAPTURE(pose.angle, with_holes);
      SimplifyOptions options = to_count(3000);
      options.boundary = Boundary::keep;
      options.detail = 6;
      const Shape sheet = shapes::hills(200);
      const RefinedShape out = refine_shape(with_holes ? pierced(sheet) : sheet, pose, options);
      CHECK(out.report.cell_size > 0);
      CHECK(out.output.faces.size() <= 3000);
      CHECK(out.defects.boundary_edges == border_of(out.input).size());
      CHECK(border_vertices(out.output) == border_vertices(out.input));
    }
  }
}

TEST_CASE("boundaries that are all of the surface are kept without clustering", "[shapes]") {
  SimplifyOptions options = to_count(1000);
  options.boundary = Boundary::keep;
  options.detail = 6;
  const RefinedShape out = refine_shape(shapes::strip(4000, 0.02), {}, options);
  CHECK(out.report.cell_size == 0);
  CHECK(out.output.vertices.size() == out.input.vertices.size());
}

TEST_CASE("what was no surface is none worse where it is clustered first", "[shapes]") {
  for (const Shape& shape : {sheet_with_fins(200), shapes::double_sided(60),
                             joined(shapes::hills(150), turned(shapes::hills(150), 1))}) {
    const Both both = refine_both(shape, {}, to_count(1500));
    CHECK(both.clustered.defects.crowded <= both.full.defects.crowded);
    CHECK(both.clustered.defects.duplicates == 0);
    CHECK(both.clustered.defects.degenerate == 0);
    check_same_size(both);
  }
}

TEST_CASE("an error bounds boundaries whatever is clustered", "[shapes]") {
  // Enough faces for clustering to come first.
  const RefinedShape out = refine_shape(pierced(shapes::hills(730)), {}, to_relative_error(0.005));
  CHECK(out.report.cell_size > 0);
  const double error = 0.005 * length(box_of(out.input).high - box_of(out.input).low);
  CHECK(border_distance(border_of(out.output), border_of(out.input), 10) <= 1.5 * error);
  CHECK(border_distance(border_of(out.input), border_of(out.output), 10) <= 1.5 * error);
}

TEST_CASE("a piece goes by an error only where it is smaller, whatever is clustered", "[shapes]") {
  const double error = 0.01;
  SimplifyOptions options;
  options.target = Target::error(error);
  const Shape shape =
      joined(joined(shapes::hills(730), dust(300, 0.2 * error, 1)), dust(30, 1.1 * error, 2));
  const RefinedShape out = refine_shape(shape, {}, options);
  CHECK(out.report.cell_size > 0);
  REQUIRE(out.report.topology.output_pieces);
  CHECK(*out.report.topology.output_pieces >= 1 + 30);
  // What few cells share is not known to be as small.
  CHECK(*out.report.topology.output_pieces < 1 + 30 + 100);
}

}  // namespace winnow::test
