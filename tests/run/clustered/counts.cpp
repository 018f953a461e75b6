// --refine none comes within a tenth of the count, or the summary says what it reached and why.
#include "support/ply_file.hpp"
#include "support/simplified.hpp"

#include <cmath>

namespace winnow::test {

namespace {

// Heights over a square: n by n places, x and y from 0 to `side`.
template <typename Height>
Polygons field(int n, double side, const Height& height) {
  Polygons mesh;
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; k <= n; ++k) {
      const double x = side * i / n, y = side * k / n;
      mesh.vertices.push_back({x, y, height(x / side, y / side)});
      if (i == 0 || k == 0) continue;
      const std::int64_t here = i * (n + 1) + k;
      mesh.faces.push_back({here - n - 2, here - 1, here});
      mesh.faces.push_back({here - n - 2, here, here - n - 1});
    }
  }
  return mesh;
}

struct Clustered {
  std::uint64_t faces = 0, runs = 0;
  std::string notes;
};

Clustered clustered(const Polygons& mesh, std::uint64_t faces) {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  PlyStyle style;
  style.coordinate.fill(PlyType::float64);
  write_file(input, ply_file(mesh, style));
  const Words options{"--refine", "none", "--faces", std::to_string(faces)};
  const Simplified file = simplified(directory, input, options);
  CHECK(simplified_by_pipe(directory, input, options + Words{"--threads", "3"}).hash == file.hash);
  return {file.report["output"]["faces"], file.report["cluster_passes"],
          file.report["notes"].dump()};
}

void check_near(const Polygons& mesh, std::uint64_t faces) {
  const Clustered out = clustered(mesh, faces);
  CAPTURE(faces, out.faces, out.notes);
  CHECK(std::abs(static_cast<double>(out.faces) / static_cast<double>(faces) - 1) <= 0.1);
  CHECK(out.runs <= 8);
}

}  // namespace

TEST_CASE("degrees and metres come within a tenth of the count") {
  const Polygons mesh = field(150, 0.1, [](double x, double y) {
    return 400 + 300 * std::sin(9 * x) * std::cos(7 * y) + 50 * std::sin(60 * x * y);
  });
  for (const std::uint64_t faces : {500, 2'000, 10'000}) check_near(mesh, faces);
}

TEST_CASE("a vertex far off that no face uses does not matter for the count") {
  Polygons mesh = field(60, 1, [](double x, double y) { return 0.1 * std::sin(9 * x + 5 * y); });
  mesh.vertices.push_back({1e12, 0, 0});
  check_near(mesh, 1'000);
}

TEST_CASE("a patch that is small beside its box comes within a tenth of the count") {
  Polygons mesh = field(150, 180, [](double x, double y) { return 100 + x * y / 500; });
  for (auto& vertex : mesh.vertices) vertex = vertex + Point{5e5, 5e6, 0};
  mesh.vertices.push_back({0, 0, 0});
  mesh.faces.push_back({0, 1, static_cast<std::int64_t>(mesh.vertices.size() - 1)});
  for (const std::uint64_t faces : {300, 1'000}) check_near(mesh, faces);
}

TEST_CASE("a count that no cell can give is told with its reason") {
  Polygons far = field(60, 1, [](double x, double y) { return 0.1 * std::sin(9 * x + 5 * y); });
  far.vertices.push_back({1e6, 0, 0});
  far.faces.push_back({0, 1, static_cast<std::int64_t>(far.vertices.size() - 1)});
  const Polygons tube = [] {
    Polygons mesh;
    for (int i = 0; i <= 300; ++i) {
      for (int k = 0; k < 12; ++k) {
        const double turn = k * 0.5235987755982988;
        mesh.vertices.push_back({2.5 * i, std::sin(turn), std::cos(turn)});
        if (i == 0) continue;
        const std::int64_t here = 12 * i + k, next = 12 * i + (k + 1) % 12;
        mesh.faces.push_back({here - 12, next - 12, next});
        mesh.faces.push_back({here - 12, next, here});
      }
    }
    return mesh;
  }();
  const struct {
    const Polygons& mesh;
    std::uint64_t faces;
    const char* reason;
  } cases[] = {{far, 1'000, "finer cells do not exist"},
               {tube, 300, "no size of cells"},
               {field(10, 1, [](double, double) { return 0.0; }), 100'000, "no more detail"}};
  for (const auto& one : cases) {
    const Clustered out = clustered(one.mesh, one.faces);
    CAPTURE(one.reason, out.faces, out.notes);
    CHECK(out.notes.find(one.reason) != std::string::npos);
    CHECK(out.faces > 0);
    CHECK(out.runs <= 9);
  }
}

}  // namespace winnow::test
