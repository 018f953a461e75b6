// --weld makes a surface of faces that share no vertex: of any format, several files, a box, a
// pipe.
#include "support/shape_files.hpp"
#include "support/simplified.hpp"
#include "support/stl_file.hpp"

#include <cmath>

namespace winnow::test {

namespace {

// A ball of 12 n^2 faces, the corners of each moved a little by themselves.
std::vector<Triangle> jittered_ball(int n, double jitter) {
  Random random(16);
  std::vector<Triangle> faces;
  const auto corner = [&](std::size_t axis, double sign, int i, int k) {
    Point p{};
    p[axis] = sign;
    p[(axis + 1) % 3] = 2.0 * i / n - 1;
    p[(axis + 2) % 3] = sign * (2.0 * k / n - 1);
    p = unit(p);
    for (double& x : p) x = static_cast<float>(x + random.real(-jitter, jitter));
    return p;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k) {
          faces.push_back({corner(axis, sign, i, k), corner(axis, sign, i + 1, k),
                           corner(axis, sign, i + 1, k + 1)});
          faces.push_back({corner(axis, sign, i, k), corner(axis, sign, i + 1, k + 1),
                           corner(axis, sign, i, k + 1)});
        }
      }
    }
  }
  return faces;
}

nlohmann::json info_of(const std::string& path) {
  return winnow_ok({"info", path, "--json"}).json();
}

const Words how{"--ratio", "20%", "--weld", "1e-5"};

}  // namespace

TEST_CASE("a soup whose corners are off by a little is closed again", "[weld]") {
  const Directory directory;
  const std::vector<Triangle> faces = jittered_ball(30, 1e-6);
  const std::string input = directory.file("soup.stl");
  write_file(input, binary_stl(faces));
  const std::string output = directory.file("mesh.ply");
  const nlohmann::json report =
      winnow_ok(Words{"simplify", input, "-o", output, "--json"} + how).json();
  CHECK(report["weld"]["distance"] == 1e-5);
  CHECK(report["weld"]["vertices"] > 4 * 5402);
  CHECK(report["weld"]["collapsed_faces"] == 0);
  CHECK(report["output"]["faces"] == 2160);
  CHECK(report["output"]["vertices"] == 1082);
  const nlohmann::json edges = info_of(output)["edges"];
  CHECK(edges["boundary"] == 0);
  CHECK(edges["non_manifold"] == 0);
  const Simplified one = simplified(directory, input, how);
  CHECK(simplified(directory, ascii_file(input, directory.file("ascii.stl")), how).hash ==
        one.hash);
  CHECK(simplified_by_pipe(directory, input, how).hash == one.hash);
  CHECK(simplified(directory, zstd_file(input), how).hash == one.hash);
}

TEST_CASE("a percentage is one of the diagonal of the faces", "[weld]") {
  const Directory directory;
  const std::string input = directory.file("soup.stl");
  write_file(input, binary_stl(jittered_ball(10, 1e-6)));
  const Simplified one = simplified(directory, input, {"--faces", "300", "--weld", "0.001%"});
  CHECK(one.report["weld"]["distance"].get<double>() == Approx(1e-5 * std::sqrt(12)).epsilon(1e-3));
  CHECK(one.report["output"]["vertices"] == 152);
}

TEST_CASE("vertices of several files are joined across them", "[weld]") {
  const Directory directory;
  const std::vector<Triangle> faces = jittered_ball(20, 1e-6);
  const auto middle = faces.begin() + 1700;
  const std::string whole = directory.file("whole.stl");
  write_file(whole, binary_stl(faces));
  const Words parts{directory.file("a.stl"), directory.file("b.stl")};
  write_file(parts[0], binary_stl({faces.begin(), middle}));
  write_file(parts[1], binary_stl({middle, faces.end()}));
  const std::string output = directory.file("mesh.ply");
  winnow_ok(Words{"simplify"} + parts + Words{"-o", output} + how);
  CHECK(hash_of_file(output) == simplified(directory, whole, how).hash);
  CHECK(info_of(output)["edges"]["boundary"] == 0);
}

TEST_CASE("only what is in the box is joined", "[weld]") {
  const Directory directory;
  const std::vector<Triangle> faces = jittered_ball(20, 1e-6);
  std::vector<Triangle> inside;
  for (const Triangle& face : faces) {
    if (face[0][2] >= 0 && face[1][2] >= 0 && face[2][2] >= 0) inside.push_back(face);
  }
  const std::string whole = directory.file("whole.stl"), half = directory.file("half.stl");
  write_file(whole, binary_stl(faces));
  write_file(half, binary_stl(inside));
  const Words box{"--crop", "-9,-9,0,9,9,9"};
  const Simplified cropped = simplified(directory, whole, how + box);
  const Simplified alone = simplified(directory, half, how + box);
  // The lattice differs, and with it which of several vertices stays.
  CHECK(cropped.report["weld"] == alone.report["weld"]);
  CHECK(cropped.report["output"]["faces"] == alone.report["output"]["faces"]);
  CHECK(cropped.report["output"]["vertices"] == alone.report["output"]["vertices"]);
  CHECK(cropped.report["input"]["cropped_faces"] == faces.size() - inside.size());
}

TEST_CASE("faces that lose a corner are counted and are no bad faces", "[weld]") {
  const Directory directory;
  const std::string input = directory.file("thin.stl");
  std::vector<Triangle> faces = jittered_ball(8, 0);
  const std::size_t whole = faces.size();
  for (int i = 0; i < 5; ++i)
    faces.push_back({Point{0, 0, 0}, Point{0, 0, 1e-7}, Point{0.5, 0.5, 0.0625 * i}});
  faces.push_back({Point{0, 0, 0}, Point{0, 0, 0}, Point{1, 1, 1}});
  write_file(input, binary_stl(faces));
  for (const Words& options :
       {Words{"--faces", "300"}, Words{"--cell", "0.1"}, Words{"--grid", "30"},
        Words{"--faces", "300", "--refine", "none"}, Words{"--error", "1%"}}) {
    INFO(joined(options));
    const nlohmann::json report =
        simplified(directory, input, options + Words{"--weld", "1e-6"}).report;
    CHECK(report["weld"]["collapsed_faces"] == 5);
    CHECK(report["weld"]["vertices"] == 1);
    CHECK(report["input"]["faces"] == whole + 6);
    CHECK(report["input"]["cropped_faces"] == 0);
    CHECK(report["input"]["bad_faces"]["degenerate"] == 1);
  }
  const Run strict = run_winnow({"simplify", input, "-o", directory.file("none.ply"), "--faces",
                                 "300", "--weld", "1e-6", "--strict"});
  CHECK(strict.code == 3);
  CHECK(strict.err.find("face " + std::to_string(whole + 5)) != std::string::npos);
}

}  // namespace winnow::test
