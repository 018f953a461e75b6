// Normals and colours of a GLB from file to file: to a GLB and back to the bit, as colours to the
// others.
#include "base/attribute.hpp"
#include "base/srgb.hpp"
#include "support/attributes.hpp"
#include "support/budget.hpp"
#include "support/glb_file.hpp"
#include "support/gltf_file.hpp"
#include "support/simplified.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace winnow::test {

namespace {

std::vector<Column> columns_of(NumberType type, bool alpha) {
  const double full = full_component(type);
  const auto wave = [full](double a, double b) {
    return
        [full, a, b](const Point& p) { return full * (0.5 + 0.5 * std::sin(a * p[0] + b * p[1])); };
  };
  std::vector<Column> columns{
      {"nx", NumberType::float32, [](const Point&) { return 0.6; }},
      {"ny", NumberType::float32, [](const Point& p) { return p[0] > 0 ? 0.8 : -0.8; }},
      {"nz", NumberType::float32, [](const Point&) { return 0.0; }},
      {"red", type, wave(3, 20)},
      {"green", type, wave(31, 7)},
      {"blue", type, wave(2, 9)}};
  if (alpha)
    columns.push_back({"alpha", type, [full](const Point& p) { return full * std::abs(p[0]); }});
  return columns;
}

struct Case {
  Directory directory;

  explicit Case(std::uint64_t faces, const std::vector<Column>& columns) {
    write_attributed(file("in.ply"), generated(directory.path(), faces), columns);
  }
  std::string file(const std::string& name) const { return directory.file(name); }
  std::string converted(const std::string& in, const std::string& out,
                        const Words& options = {}) const {
    winnow_ok(Words{"convert", file(in), "-o", file(out), "-q", "--force"} + options);
    return bytes_of_file(file(out));
  }
};

// All that each vertex has.
std::vector<std::vector<double>> sorted_vertices(const std::string& path) {
  const AttributedMesh mesh = read_attributed(path);
  std::vector<std::vector<double>> vertices;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    auto& vertex = vertices.emplace_back(mesh.positions[v].begin(), mesh.positions[v].end());
    for (const auto& [name, numbers] : mesh.columns) vertex.push_back(numbers[v]);
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

// A mesh of a triangle for each three of these bytes' eight-bit colours.
GltfBuilder colored_triangles(const std::vector<std::uint8_t>& bytes) {
  GltfBuilder file;
  std::vector<Point> points;
  for (std::size_t i = 0; i < bytes.size() / 4; ++i) {
    const double at = static_cast<double>(i / 3);
    points.push_back({at + (i % 3 == 1 ? 0.5 : 0), i % 3 == 2 ? 0.5 : 0, at});
  }
  const std::size_t positions = file.positions(points);
  const std::size_t colors = file.numbers(bytes, 5121, "VEC4", true);
  file.mesh(Json::array({{{"attributes", {{"POSITION", positions}, {"COLOR_0", colors}}}}}));
  return file;
}

}  // namespace

TEST_CASE("a PLY that goes through a GLB keeps its normals and colours", "[same_bytes]") {
  for (const NumberType type : {NumberType::uint8, NumberType::uint16, NumberType::float32}) {
    const bool alpha = type != NumberType::float32;
    const Case test(3000, columns_of(type, alpha));
    const std::string glb = test.converted("in.ply", "out.glb");
    // Once more nothing changes, and packed no more than the order.
    CHECK(test.converted("out.glb", "again.glb") == glb);
    test.converted("out.glb", "packed.glb", {"--compress", "meshopt"});
    test.converted("packed.glb", "packed.ply");
    test.converted("out.glb", "back.ply");
    CHECK(sorted_vertices(test.file("packed.ply")) == sorted_vertices(test.file("back.ply")));
    const AttributedMesh in = read_attributed(test.file("in.ply"));
    const AttributedMesh back = read_attributed(test.file("back.ply"));
    REQUIRE(back.positions == in.positions);
    CHECK(back.faces == in.faces);
    REQUIRE(back.columns.size() == in.columns.size());
    for (const auto& [name, numbers] : in.columns) {
      INFO(name);
      const bool normal = name[0] == 'n';
      const double full = normal ? 1 : full_component(type);
      // Sixteen bits of light hold all of eight of colour; of more, floats do.
      const double full_back = !normal && type == NumberType::uint8 ? 65535 : 1;
      const std::vector<double>& found = back.columns.at(name);
      double worst = 0;
      for (std::size_t v = 0; v < numbers.size(); ++v) {
        worst = std::max(worst, std::abs(found[v] / full_back - numbers[v] / full));
        if (full > 1 && std::nearbyint(found[v] / full_back * full) != numbers[v])
          FAIL("vertex " << v);
      }
      CHECK(worst <= (normal ? 0 : full_back > 1 ? 2e-4 : 1e-6));
    }
  }
}

TEST_CASE("eight bits of light of a GLB stay what they are, and become eight bits of colour") {
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 256; ++i)
    bytes.insert(bytes.end(), {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i),
                               static_cast<std::uint8_t>(i / 2), static_cast<std::uint8_t>(i)});
  bytes.resize(255 * 4);
  const Directory directory;
  write_file(directory.file("in.glb"), colored_triangles(bytes).glb());
  // Every cell of the lattice has one vertex.
  for (const Words& command : {Words{"convert"}, Words{"simplify", "--cell", "0.1"}}) {
    INFO(joined(command));
    const Words options{directory.file("in.glb"), "--json", "--force"};
    winnow_ok(command + options + Words{"-o", directory.file("out.glb")});
    const GlbFile glb = glb_file(bytes_of_file(directory.file("out.glb")));
    CHECK(glb.color_type == 5121);
    REQUIRE(glb.colors.size() == bytes.size());
    for (std::size_t v = 0; v < glb.positions.size(); ++v) {
      const auto& p = glb.positions[v];
      const auto from = 3 * static_cast<std::size_t>(p[2]) + (p[1] > 0 ? 2 : p[0] > p[2] ? 1 : 0);
      for (std::size_t i = 0; i < 4; ++i)
        REQUIRE(glb.colors[4 * v + i] == static_cast<float>(bytes[4 * from + i] / 255.0));
    }
    const Run run = winnow_ok(command + options + Words{"-o", directory.file("out.ply")});
    CHECK(run.json()["attributes"]["carried"] ==
          nlohmann::json{"red (uchar)", "green (uchar)", "blue (uchar)", "alpha (uchar)"});
    const AttributedMesh ply = read_attributed(directory.file("out.ply"));
    for (std::size_t v = 0; v < ply.positions.size(); ++v) {
      const Point& p = ply.positions[v];
      const auto from = 3 * static_cast<std::size_t>(p[2]) + (p[1] > 0 ? 2 : p[0] > p[2] ? 1 : 0);
      REQUIRE(ply.columns.at("red")[v] ==
              std::nearbyint(255 * component_of_light(bytes[4 * from] / 255.0)));
      REQUIRE(ply.columns.at("alpha")[v] == bytes[4 * from + 3]);
    }
  }
}

TEST_CASE("a GLB and a PLY carry colours together where they are of one type", "[same_bytes]") {
  const Case test(4000, columns_of(NumberType::float32, false));
  test.converted("in.ply", "same.glb");
  // The first says in which order, and whether it is light; both say the same colours.
  const Words options{"--cell", "0.02", "--json"};
  const auto joined_by = [&](const Words& names) {
    Words command{"simplify"};
    for (const std::string& name : names) command.push_back(test.file(name));
    const Run run = winnow_ok(command + options + Words{"-o", test.file("out.ply"), "--force"});
    CHECK(run.json()["attributes"]["carried"].size() == 6);
    return read_attributed(test.file("out.ply"));
  };
  const AttributedMesh alone = joined_by({"in.ply", "in.ply"});
  for (const Words& names :
       {Words{"in.ply", "same.glb"}, Words{"same.glb", "in.ply"}, Words{"same.glb", "same.glb"}}) {
    INFO(joined(names));
    const AttributedMesh mixed = joined_by(names);
    CHECK(mixed.positions == alone.positions);
    for (const auto& [name, numbers] : alone.columns) {
      double worst = 0;
      for (std::size_t v = 0; v < numbers.size(); ++v)
        worst = std::max(worst, std::abs(numbers[v] - mixed.columns.at(name)[v]));
      INFO(name);
      CHECK(worst < 1e-6);
    }
  }
}

TEST_CASE("attributes of a GLB are the same from files and pipes, and within the budget",
          "[same_bytes][budget]") {
  const Case test(80'000, columns_of(NumberType::uint8, true));
  test.converted("in.ply", "in.glb");
  const std::string input = test.file("in.glb");
  const Words options{"--faces", "10k"};
  const Words two = options + Words{"--threads", "2"};
  const Simplified want = simplified(test.directory, input, options + Words{"--threads", "1"});
  CHECK(want.report["attributes"]["carried"].size() == 7);
  CHECK(simplified_by_pipe(test.directory, input, two).hash == want.hash);
  CHECK(simplified(test.directory, zstd_file(input), two).hash == want.hash);
  CHECK(simplified(test.directory, input, two + Words{"--memory", smallest_memory(input, two)})
            .hash == want.hash);
  check_budget(test.directory, input, two, "smallest");
  // What is carried changes nothing of where vertices go.
  const auto geometry = [&](const Words& more) {
    winnow_ok(Words{"simplify", input, "-o", test.file("out.ply"), "-q", "--force"} + two + more);
    const AttributedMesh mesh = read_attributed(test.file("out.ply"));
    return std::pair(mesh.positions, mesh.faces);
  };
  CHECK(geometry({}) == geometry({"--attributes", "none"}));
}

}  // namespace winnow::test
