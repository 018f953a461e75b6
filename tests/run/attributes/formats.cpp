// Colours and normals from format to format.
#include "base/srgb.hpp"
#include "support/attributes.hpp"
#include "support/glb_file.hpp"
#include "support/simplified.hpp"

#include <cmath>
#include <map>

namespace winnow::test {

namespace {

std::vector<Column> colors_of(NumberType type) {
  const double full = is_integer(type) ? 255 : 1;
  const auto wave = [full](double a, double b) {
    return
        [full, a, b](const Point& p) { return full * (0.5 + 0.5 * std::sin(a * p[0] + b * p[1])); };
  };
  return {{"red", type, wave(3, 20)}, {"green", type, wave(31, 7)}, {"blue", type, wave(2, 9)}};
}

std::vector<Column> normals() {
  return {{"nx", NumberType::float32, [](const Point&) { return 0.6; }},
          {"ny", NumberType::float32, [](const Point& p) { return p[0] > 0 ? 0.8 : -0.8; }},
          {"nz", NumberType::float32, [](const Point&) { return 0.0; }}};
}

struct Case {
  Directory directory;
  AttributedMesh mesh = generated(directory.path(), 4000);

  std::string file(const std::string& name) const { return directory.file(name); }
  // Nothing goes: every vertex keeps what it carries.
  Run all(const std::string& in, const std::string& out, const Words& options = {}) const {
    return winnow_ok(
        Words{"simplify", file(in), "-o", file(out), "--faces", "1M", "--json", "--force"} +
        options);
  }
};

// `out` has the numbers of `in` at the same positions, times `factor`, to within `tolerance`.
void check_columns(const AttributedMesh& out, const AttributedMesh& in, double factor,
                   double tolerance) {
  REQUIRE(out.positions.size() == in.positions.size());
  std::map<Point, std::size_t> at;
  for (std::size_t v = 0; v < in.positions.size(); ++v) at[in.positions[v]] = v;
  for (const auto& [name, numbers] : in.columns) {
    INFO(name);
    REQUIRE(out.columns.count(name) == 1);
    double worst = 0;
    for (std::size_t v = 0; v < numbers.size(); ++v) {
      const double want = factor * numbers[at.at(out.positions[v])];
      worst = std::max(worst, std::abs(out.columns.at(name)[v] - want));
    }
    CHECK(worst <= tolerance);
  }
}

}  // namespace

TEST_CASE("colours go to OBJ and OFF and come back") {
  const Case test;
  for (const NumberType type : {NumberType::uint8, NumberType::float32}) {
    write_attributed(test.file("in.ply"), test.mesh, colors_of(type));
    const AttributedMesh in = read_attributed(test.file("in.ply"));
    const double full = type == NumberType::uint8 ? 255 : 1;
    CHECK(test.all("in.ply", "out.obj").json()["attributes"]["dropped"].empty());
    CHECK(test.all("out.obj", "back.ply").json()["attributes"]["carried"] ==
          nlohmann::json{"red (float)", "green (float)", "blue (float)"});
    check_columns(read_attributed(test.file("back.ply")), in, 1 / full, 1e-6);
    test.all("in.ply", "out.off");
    const Run back = test.all("out.off", "back.ply");
    CHECK(back.json()["attributes"]["carried"].size() == 4);
    CHECK(back.json()["attributes"]["carried"][3] ==
          (full > 1 ? "alpha (uchar)" : "alpha (float)"));
    const AttributedMesh out = read_attributed(test.file("back.ply"));
    check_columns(out, in, 1, full > 1 ? 0 : 1e-6);
    for (const double alpha : out.columns.at("alpha")) CHECK(alpha == full);
    // The second way there is the same.
    test.all("back.ply", "again.off");
    test.all("out.off", "same.off");
    CHECK(hash_of_file(test.file("again.off")) == hash_of_file(test.file("same.off")));
  }
}

TEST_CASE("normals that are carried are those that OBJ OFF and GLB get") {
  const Case test;
  std::vector<Column> columns = normals();
  for (const Column& color : colors_of(NumberType::uint8)) columns.push_back(color);
  write_attributed(test.file("in.ply"), test.mesh, columns);
  const AttributedMesh in = read_attributed(test.file("in.ply"));
  CHECK(test.all("in.ply", "out.off").json()["attributes"]["carried"].size() == 6);
  CHECK(bytes_of_file(test.file("out.off")).starts_with("CNOFF\n"));
  test.all("out.off", "back.ply");
  check_columns(read_attributed(test.file("back.ply")), in, 1, 1e-7);
  test.all("in.ply", "out.obj", {"--attributes", "normals"});
  CHECK(bytes_of_file(test.file("out.obj")).find("\nvn 0.6 -0.8 0\n") != std::string::npos);
  test.all("in.ply", "out.glb");
  const GlbFile glb = glb_file(bytes_of_file(test.file("out.glb")));
  for (const auto& normal : glb.normals) CHECK((normal[0] == 0.6F && std::abs(normal[1]) == 0.8F));
  test.all("in.ply", "none.off", {"--attributes", "none"});
  CHECK(bytes_of_file(test.file("none.off")).starts_with("OFF\n"));
}

TEST_CASE("eight bits of colour become sixteen of light in a GLB", "[same_bytes]") {
  const Case test;
  for (const bool alpha : {false, true}) {
    std::vector<Column> columns = colors_of(NumberType::uint8);
    if (alpha)
      columns.push_back(
          {"alpha", NumberType::uint8, [](const Point& p) { return 255 * std::abs(p[0]); }});
    write_attributed(test.file("in.ply"), test.mesh, columns);
    const AttributedMesh in = read_attributed(test.file("in.ply"));
    std::map<std::array<float, 3>, std::size_t> at;
    for (std::size_t v = 0; v < in.positions.size(); ++v) {
      const auto& p = in.positions[v];
      at[{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}] = v;
    }
    for (const Words& packing : {Words{}, Words{"--compress", "meshopt"}}) {
      INFO(joined(packing));
      test.all("in.ply", "out.glb", packing + Words{"--threads", "1"});
      const std::string hash = hash_of_file(test.file("out.glb"));
      test.all("in.ply", "out.glb", packing + Words{"--threads", "3"});
      CHECK(hash_of_file(test.file("out.glb")) == hash);
      const GlbFile glb = glb_file(bytes_of_file(test.file("out.glb")));
      REQUIRE(glb.colors.size() == glb.positions.size() * (alpha ? 4 : 3));
      float worst = 0;
      for (std::size_t v = 0; v < glb.positions.size(); ++v) {
        const std::size_t from = at.at(glb.positions[v]);
        for (std::size_t i = 0; i < 3; ++i) {
          const double stored = in.columns.at(columns[i].name)[from] / 255;
          const auto want = static_cast<float>(light_of_component(stored));
          worst = std::max(worst, std::abs(glb.colors[v * (alpha ? 4 : 3) + i] - want));
        }
        if (alpha) {
          const auto want = static_cast<float>(in.columns.at("alpha")[from] / 255);
          worst = std::max(worst, std::abs(glb.colors[4 * v + 3] - want));
        }
      }
      CHECK(glb.color_type == 5123);
      CHECK(worst <= 0.5F / 65535 + 1e-7F);
    }
  }
}

TEST_CASE("what OBJ OFF .m and GLB cannot hold is told") {
  const Case test;
  write_attributed(test.file("in.ply"), test.mesh, usual_columns());
  for (const char* out : {"out.obj", "out.off", "out.m", "out.glb"}) {
    const Run run = test.all("in.ply", out);
    INFO(out);
    CHECK(run.json()["attributes"]["carried"].size() == 3);
    CHECK(run.json()["attributes"]["dropped"] ==
          nlohmann::json{
              "the output's format holds no attributes but normals and colours: quality, label, "
              "stamp"});
  }
  write_attributed(test.file("in.ply"), test.mesh, normals());
  CHECK(test.all("in.ply", "out.obj", {"--attributes", "nx"})
            .json()["attributes"]["dropped"]
            .size() == 1);
}

TEST_CASE("an alpha without a colour goes to no format that has it only with one") {
  const Case test;
  std::vector<Column> columns{{"alpha", NumberType::uint8, [](const Point&) { return 7; }}};
  write_attributed(test.file("alone.ply"), test.mesh, columns);
  columns.push_back({"red", NumberType::uint8, [](const Point&) { return 9; }});
  write_attributed(test.file("in.ply"), test.mesh, columns);
  const nlohmann::json told{
      "the output's format holds no attributes but normals and colours: alpha"};
  for (const char* out : {"out.obj", "out.off", "out.glb"}) {
    INFO(out);
    const nlohmann::json alone = test.all("alone.ply", out).json()["attributes"];
    CHECK(alone["carried"].empty());
    CHECK(alone["dropped"] == told);
    const nlohmann::json asked =
        test.all("in.ply", out, {"--attributes", "alpha"}).json()["attributes"];
    CHECK(asked["carried"].empty());
    const nlohmann::json both = test.all("in.ply", out).json()["attributes"];
    CHECK(both["carried"].size() == (std::string(out) == "out.obj" ? 1 : 2));
  }
  CHECK(test.all("alone.ply", "out.ply").json()["attributes"]["carried"].size() == 1);
}

}  // namespace winnow::test
