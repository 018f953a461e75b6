// A scan at georeferenced coordinates is as precise as the same scan at the origin, all the way to
// the file.
#include <winnow/compare.hpp>

#include "generate/generate.hpp"
#include "support/glb_file.hpp"
#include "support/ply_file.hpp"
#include "support/program.hpp"
#include "support/reading.hpp"
#include "support/refined_file.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

const Point far{431000, 5412000, 300};

// A scan two metres across with detail of a millimetre, its coordinates rounded to 2^-24 m: so that
// moving it by a whole number of those is exact.
Polygons fine_scan(const Directory& directory, std::uint64_t faces) {
  const std::string path = directory.file("scan.ply");
  generate("scan", faces, path);
  TestJob test;
  const auto reader = open_reader(test.job, open_source(test.job, path), Format::automatic,
                                  Access::repeatedly, {usual_vertex_memory, 8192});
  Polygons mesh;
  mesh.vertices = read_positions(test.job, *reader);
  for (Point& p : mesh.vertices) {
    for (double& x : p) x = std::nearbyint(x * 0x1p24) * 0x1p-24;
  }
  const std::string file = bytes_of_file(path);
  const std::size_t count = *reader->facts().faces;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::uint32_t, 3> index{};
    std::memcpy(index.data(), file.data() + file.size() - 13 * (count - i) + 1, 12);
    mesh.faces.push_back({index[0], index[1], index[2]});
  }
  return mesh;
}

Polygons moved(Polygons mesh, const Point& by) {
  for (Point& p : mesh.vertices) p = p + by;
  return mesh;
}

std::string write_doubles(const Directory& directory, const std::string& name,
                          const Polygons& mesh) {
  PlyStyle style;
  style.coordinate = {PlyType::float64, PlyType::float64, PlyType::float64};
  const std::string path = directory.file(name);
  write_file(path, ply_file(mesh, style));
  return path;
}

// The output as polygons, moved back by `by`.
Polygons back(const RefinedFile& out, const Point& by) {
  Polygons mesh;
  for (const IndexedVertex& vertex : out.mesh.vertices)
    mesh.vertices.push_back(vertex.position - by);
  for (const FaceVertices& face : out.mesh.faces) mesh.faces.push_back({face[0], face[1], face[2]});
  return mesh;
}

double error_of_result(const Directory& directory, const std::string& original,
                       const Polygons& result) {
  const std::string path = write_doubles(directory, "result.ply", result);
  CompareOptions how;
  how.samples = 200'000;
  Context context;
  context.scratch = directory.path();
  return compare(context, original, path, how).symmetric.rms;
}

SimplifyOptions by(const char* how) {
  SimplifyOptions options;
  const std::string what(how);
  if (what == "cell") options.target = Target::cell(0x1p-6);
  if (what == "grid") options.target = Target::grid(100);
  if (what == "error") options.target = Target::error(0.002);
  if (what == "faces" || what == "full") options.target = Target::faces(3000);
  if (what == "clustered") {
    options.target = Target::faces(2000);
    options.detail = 4;
  }
  if (what == "full") options.detail = std::numeric_limits<double>::infinity();
  return options;
}

}  // namespace

TEST_CASE("a scan moved by whole cells keeps its faces, and all digits of its vertices", "[long]") {
  const Directory directory;
  const Polygons scan = fine_scan(directory, 40'000);
  const std::string near = write_doubles(directory, "near.ply", scan);
  const std::string away = write_doubles(directory, "away.ply", moved(scan, far));
  for (const char* how : {"cell", "grid", "faces", "full", "clustered", "error"}) {
    CAPTURE(how);
    const RefinedFile here = refine_file(directory, near, by(how));
    const RefinedFile there = refine_file(directory, away, by(how));
    CHECK(there.mesh.faces == here.mesh.faces);
    REQUIRE(there.mesh.vertices.size() == here.mesh.vertices.size());
    double farthest = 0;
    for (std::size_t i = 0; i < here.mesh.vertices.size(); ++i) {
      const Point apart = there.mesh.vertices[i].position - far - here.mesh.vertices[i].position;
      farthest = std::max(farthest, length(apart));
    }
    // A double steps by 2^-30 there.
    CHECK(farthest < 1e-7);
  }
}

TEST_CASE("a vertex at the origin of georeferenced coordinates changes next to nothing",
          "[slow][long]") {
  const Directory directory;
  Polygons scan = moved(fine_scan(directory, 300'000), far);
  const std::string clean = write_doubles(directory, "clean.ply", scan);
  scan.vertices.push_back({0, 0, 0});
  const std::string stray = write_doubles(directory, "stray.ply", scan);
  SimplifyOptions options = by("faces");
  // No face uses it, so it makes no box larger.
  for (const bool cluster : {false, true}) {
    CAPTURE(cluster);
    if (cluster) options.detail = 4;
    const RefinedFile without = refine_file(directory, clean, options);
    const RefinedFile with = refine_file(directory, stray, options);
    CHECK(with.report.output.faces == 3000);
    CHECK(with.report.refine.tiles >= without.report.refine.tiles);
    CHECK((with.report.cell_size > 0) == cluster);
    CHECK(with.report.notes.size() == without.report.notes.size());
    const double right = error_of_result(directory, clean, back(without, {}));
    CHECK(error_of_result(directory, clean, back(with, {})) < 1.1 * right);
  }
  options = by("error");
  CHECK(refine_file(directory, stray, options).report.output.faces ==
        Approx(static_cast<double>(refine_file(directory, clean, options).report.output.faces))
            .epsilon(0.1));
}

TEST_CASE("a scan moved by anything is simplified with the same error", "[long]") {
  const Directory directory;
  const Polygons scan = fine_scan(directory, 40'000);
  const std::string near = write_doubles(directory, "near.ply", scan);
  const Point odd{431000.123456789, 5412000.987654321, 300.55555};
  const std::string away = write_doubles(directory, "away.ply", moved(scan, odd));
  for (const char* how : {"faces", "full", "clustered"}) {
    CAPTURE(how);
    const RefinedFile here = refine_file(directory, near, by(how));
    const RefinedFile there = refine_file(directory, away, by(how));
    const double right = error_of_result(directory, near, back(here, {}));
    const double found = error_of_result(directory, near, back(there, odd));
    CHECK(right > 0);
    CHECK(found == Approx(right).epsilon(0.01));
    CHECK(there.report.output.faces == here.report.output.faces);
  }
}

TEST_CASE("a GLB of a georeferenced scan has its detail, floats are said to lose it") {
  const Directory directory;
  const Polygons scan = fine_scan(directory, 20'000);
  const std::string away = write_doubles(directory, "away.ply", moved(scan, far));
  Context context;
  context.scratch = directory.path();
  SimplifyOptions options = by("faces");
  const RefinedFile exact = refine_file(directory, away, options);
  CHECK(exact.report.notes.empty());
  CHECK(simplify(context, away, directory.file("out.glb"), options).notes.empty());
  const GlbFile glb = glb_file(bytes_of_file(directory.file("out.glb")));
  CHECK(length(glb.offset - far) < 4);
  REQUIRE(glb.positions.size() == exact.mesh.vertices.size());
  double farthest = 0;
  std::vector<Point> positions;
  for (const auto& p : glb.positions) positions.push_back(Point{p[0], p[1], p[2]} + glb.offset);
  std::sort(positions.begin(), positions.end());
  std::vector<Point> right;
  for (const IndexedVertex& vertex : exact.mesh.vertices) right.push_back(vertex.position);
  std::sort(right.begin(), right.end());
  for (std::size_t i = 0; i < right.size(); ++i)
    farthest = std::max(farthest, std::abs(positions[i][0] - right[i][0]));
  CHECK(farthest < 1e-6);

  options.encoding.positions = Positions::floats;
  CHECK(simplify(context, away, directory.file("floats.ply"), options).notes.size() == 1);
  options.encoding.positions = Positions::as_input;
  CHECK(simplify(context, away, directory.file("out.stl"), options).notes.size() == 1);
}

}  // namespace winnow::test
