// What is averaged stays what it has to stay: a constant, the slope of a line, the mean of the
// light.
#include "base/srgb.hpp"
#include "support/attributes.hpp"
#include "support/not_finite.hpp"
#include "support/simplified.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winnow::test {

namespace {

// Clustered alone by either placement; all faces refined, in several tiles; clustered and then
// refined.
const std::vector<Words>& ways() {
  static const std::vector<Words> ways{{"--grid", "40"},
                                       {"--grid", "40", "--placement", "mean"},
                                       {"--faces", "5k"},
                                       {"--faces", "5k", "--refine", "importance"},
                                       {"--faces", "5k", "--detail", "4"},
                                       {"--error", "1%"}};
  return ways;
}

AttributedMesh simplified_mesh(const Directory& directory, const std::string& in,
                               const Words& options) {
  const std::string out = directory.file("out.ply");
  winnow_ok(Words{"simplify", in, "-o", out, "--force", "-q"} + options);
  return read_attributed(out);
}

double largest_difference(const AttributedMesh& mesh, const std::string& name,
                          const std::function<double(const Point&)>& expected) {
  double largest = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    largest = std::max(largest, std::abs(mesh.columns.at(name)[v] - expected(mesh.positions[v])));
  return largest;
}

}  // namespace

TEST_CASE("a constant attribute stays what it is", "[long]") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  const auto constant = [](const std::string& name, NumberType type, double value) {
    return Column{name, type, [value](const Point&) { return value; }};
  };
  const std::vector<Column> columns{constant("nx", NumberType::float64, 0.48),
                                    constant("ny", NumberType::float64, 0.6),
                                    constant("nz", NumberType::float64, 0.64),
                                    constant("red", NumberType::uint8, 77),
                                    constant("green", NumberType::uint16, 54321),
                                    constant("blue", NumberType::float32, 0.7F),
                                    constant("label", NumberType::uint32, 4000000001),
                                    constant("small", NumberType::float64, 1.1e-300),
                                    constant("large", NumberType::float64, -1.7e308)};
  write_attributed(in, generated(directory.path(), 80'000), columns);
  for (const Words& way : ways()) {
    const AttributedMesh mesh = simplified_mesh(directory, in, way);
    for (const Column& column : columns) {
      INFO(joined(way) << " " << column.name);
      CHECK(largest_difference(mesh, column.name, column.value) == 0);
    }
  }
}

TEST_CASE("a linear attribute stays near its line", "[long]") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  const auto line = [](const Point& p) { return 3 * p[0] - 2 * p[1] + p[2]; };
  const double slope = std::sqrt(14.0);
  write_attributed(in, generated(directory.path(), 80'000), {{"line", NumberType::float64, line}});
  const AttributedMesh whole = read_attributed(in);
  for (const Words& way : ways()) {
    INFO(joined(way));
    const AttributedMesh mesh = simplified_mesh(directory, in, way);
    double longest = 0;
    for (const auto& face : mesh.faces) {
      for (std::size_t i = 0; i < 3; ++i)
        longest =
            std::max(longest, length(mesh.positions[face[i]] - mesh.positions[face[(i + 1) % 3]]));
    }
    // No vertex has its number from farther away than a face is long.
    CHECK(largest_difference(mesh, "line", line) < slope * longest);
    const auto itself = [](double x) { return x; };
    CHECK(mean_over_surface(mesh, "line", itself) ==
          Approx(mean_over_surface(whole, "line", itself)).margin(0.02 * slope));
  }
}

TEST_CASE("the mean of the light is kept", "[long]") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  // Black and white by halves of a fine grain: averaged as they are stored it would become darker.
  const auto grain = [](const Point& p) {
    return std::sin(2000 * p[0]) * std::sin(3000 * p[1] + 2500 * p[2]) > 0 ? 255.0 : 0.0;
  };
  write_attributed(in, generated(directory.path(), 80'000), {{"red", NumberType::uint8, grain}});
  const auto light = [](double x) { return light_of_component(x / 255); };
  const double before = mean_over_surface(read_attributed(in), "red", light);
  CHECK(before == Approx(0.5).margin(0.05));
  for (const Words& way : ways()) {
    INFO(joined(way));
    CHECK(mean_over_surface(simplified_mesh(directory, in, way), "red", light) ==
          Approx(before).margin(0.02));
  }
}

TEST_CASE("numbers that are none are counted and left out of means") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  const AttributedMesh mesh = generated(directory.path(), 80'000);
  std::uint64_t count = 0;
  const auto spoilt = [&](const Point& p) {
    if (std::sin(5000 * p[0]) < 0.9) return 5.0;
    ++count;
    if (p[2] > 0.1) return static_cast<double>(std::numeric_limits<float>::lowest());
    return p[1] > 0 ? infinity : nan;
  };
  write_attributed(in, mesh, {{"quality", NumberType::float32, spoilt}});
  REQUIRE(count > 1000);
  const std::string out = directory.file("out.ply");
  for (const std::string& input : {in, zstd_file(in)}) {
    const Run run = winnow_ok({"simplify", input, "-o", out, "--grid", "40", "--json", "--force"});
    CHECK(run.json()["attributes"]["ignored_values"] == count);
    CHECK(run.json()["notes"].size() == 1);
    // Where there is nothing else, in a cell of few vertices, the mean is 0.
    const std::vector<double> numbers = read_attributed(out).columns.at("quality");
    const auto fives = std::count(numbers.begin(), numbers.end(), 5.0);
    const auto zeros = std::count(numbers.begin(), numbers.end(), 0.0);
    CHECK(static_cast<std::size_t>(fives + zeros) == numbers.size());
    CHECK(zeros < fives / 50);
  }
}

TEST_CASE("attributes change no vertex and no face", "[long]") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  const AttributedMesh plain = generated(directory.path(), 80'000);
  for (const Words& way : ways()) {
    INFO(joined(way));
    write_attributed(in, plain, {});
    const AttributedMesh without = simplified_mesh(directory, in, way);
    write_attributed(in, plain, usual_columns());
    const AttributedMesh with = simplified_mesh(directory, in, way);
    CHECK(with.columns.size() == usual_columns().size());
    CHECK((with.positions == without.positions));
    CHECK((with.faces == without.faces));
  }
}

TEST_CASE("colours of vertices at one place are averaged") {
  // Two faces of a square that share no vertex: red on one side of the seam, blue on the other.
  const Directory directory;
  const std::string in = directory.file("in.ply");
  write_file(in,
             "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float "
             "y\nproperty float z\n"
             "property uchar red\nproperty uchar blue\nelement face 2\n"
             "property list uchar int vertex_indices\nend_header\n"
             "0 0 0 255 0\n1 0 0 255 0\n1 1 0 255 0\n0 0 0 0 255\n1 1 0 0 255\n0 1 0 0 255\n"
             "3 0 1 2\n3 3 4 5\n");
  const AttributedMesh mesh = simplified_mesh(directory, in, {"--faces", "4"});
  REQUIRE(mesh.positions.size() == 4);
  for (std::size_t v = 0; v < 4; ++v) {
    const bool seam = mesh.positions[v][0] == mesh.positions[v][1];
    const double right = mesh.positions[v][0] > mesh.positions[v][1] ? 255 : 0;
    CHECK(mesh.columns.at("red")[v] == (seam ? 188 : right));
    CHECK(mesh.columns.at("blue")[v] == (seam ? 188 : 255 - right));
  }
}

}  // namespace winnow::test
