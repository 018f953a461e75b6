// What vertices carry arrives at the output: every type from every form of file, and with no sum in
// between where nothing is averaged.
#include "support/attributes.hpp"
#include "support/simplified.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace winnow::test {

namespace {

std::vector<Column> all_types() {
  const auto some = [](double factor) {
    return [factor](const Point& p) { return factor * std::sin(40 * p[0] + 9 * p[1]); };
  };
  return {
      {"nx", NumberType::float32, [](const Point&) { return 0.6; }},
      {"ny", NumberType::float32, [](const Point& p) { return p[0] > 0 ? 0.8 : -0.8; }},
      {"nz", NumberType::float32, [](const Point&) { return 0.0; }},
      {"red", NumberType::uint8,
       [](const Point& p) { return std::abs(255 * std::sin(90 * p[0])); }},
      {"green", NumberType::uint16,
       [](const Point& p) { return std::abs(65535 * std::sin(90 * p[0])); }},
      {"blue", NumberType::float32, [](const Point& p) { return std::abs(std::sin(90 * p[0])); }},
      {"i1", NumberType::int8, some(127)},
      {"u1", NumberType::uint8, [](const Point& p) { return std::abs(255 * std::sin(50 * p[2])); }},
      {"i2", NumberType::int16, some(32767)},
      {"u2", NumberType::uint16,
       [](const Point& p) { return std::abs(65535 * std::sin(50 * p[2])); }},
      {"i4", NumberType::int32, some(2147483647)},
      {"u4", NumberType::uint32,
       [](const Point& p) { return std::abs(4294967295 * std::sin(50 * p[2])); }},
      {"f4", NumberType::float32, some(1e30)},
      {"f8", NumberType::float64,
       [](const Point& p) { return 1e250 * (2 + std::sin(50 * p[2])); }}};
}

// By position: the order of the vertices is the output's own.
void check_equal(const AttributedMesh& out, const AttributedMesh& in) {
  REQUIRE(out.properties == in.properties);
  REQUIRE(out.positions.size() == in.positions.size());
  std::map<Point, std::size_t> at;
  for (std::size_t v = 0; v < in.positions.size(); ++v) at[in.positions[v]] = v;
  for (const auto& [name, numbers] : out.columns) {
    std::uint64_t wrong = 0;
    for (std::size_t v = 0; v < numbers.size(); ++v)
      wrong += numbers[v] != in.columns.at(name)[at.at(out.positions[v])];
    INFO(name);
    CHECK(wrong == 0);
  }
}

}  // namespace

TEST_CASE("attributes of every type come through unchanged where no vertex goes") {
  const Directory directory;
  const AttributedMesh mesh = generated(directory.path(), 4000);
  const std::string in = directory.file("in.ply");
  const std::string out = directory.file("out.ply");
  write_attributed(in, mesh, all_types());
  const AttributedMesh expected = read_attributed(in);
  for (const PlyForm form : {PlyForm::little_endian, PlyForm::big_endian, PlyForm::ascii}) {
    write_attributed(in, mesh, all_types(), form);
    for (const std::string& input : {in, zstd_file(in)}) {
      CAPTURE(input, static_cast<int>(form));
      const Run run =
          winnow_ok({"simplify", input, "-o", out, "--faces", "1M", "--json", "--force"});
      check_equal(read_attributed(out), expected);
      CHECK(run.json()["attributes"]["carried"].size() == all_types().size());
      CHECK(run.json()["attributes"]["dropped"].empty());
    }
  }
}

TEST_CASE("only what is asked for is carried") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  const std::string out = directory.file("out.ply");
  write_attributed(in, generated(directory.path(), 4000), all_types());
  const auto properties = [&](const Words& options) {
    winnow_ok(Words{"simplify", in, "-o", out, "--faces", "1k", "--force", "-q"} + options);
    return read_attributed(out).properties;
  };
  const Words position{"float x", "float y", "float z"};
  const Words normals{"float nx", "float ny", "float nz"};
  CHECK(properties({"--attributes", "none"}) == position);
  CHECK(properties({"--attributes", "f8,i1"}) == position + Words{"char i1", "double f8"});
  CHECK(properties({"--attributes", "normals"}) == position + normals);
  CHECK(properties({"--attributes", "none", "--normals"}) == position + normals);
  CHECK(properties({"--attributes", "u1", "--normals"}) == position + normals + Words{"uchar u1"});
}

TEST_CASE("normals that --normals computes stand in for those of the input") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  const std::string out = directory.file("out.ply");
  const AttributedMesh mesh = generated(directory.path(), 4000);
  write_attributed(in, mesh, {});
  winnow_ok({"simplify", in, "-o", out, "--faces", "1k", "--normals", "-q"});
  const std::string computed = hash_of_file(out);
  write_attributed(in, mesh, {all_types()[0], all_types()[1], all_types()[2]});
  const Run run =
      winnow_ok({"simplify", in, "-o", out, "--faces", "1k", "--normals", "--force", "--json"});
  CHECK(hash_of_file(out) == computed);
  REQUIRE(run.json()["attributes"]["dropped"].size() == 1);
  CHECK_THAT(run.json()["attributes"]["dropped"][0].get<std::string>(),
             Catch::Contains("nx, ny, nz"));
  CHECK(run.json()["notes"].size() == 1);
}

TEST_CASE("normals in whole numbers are carried, and no others stand beside them") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  const std::string out = directory.file("out.ply");
  const auto always = [](double value) { return [value](const Point&) { return value; }; };
  write_attributed(in, generated(directory.path(), 4000),
                   {{"nx", NumberType::int8, always(0)},
                    {"ny", NumberType::int8, always(0)},
                    {"nz", NumberType::int8, always(127)}});
  const std::vector<std::string> position{"float x", "float y", "float z"};
  winnow_ok({"simplify", in, "-o", out, "--faces", "500", "-q", "--force"});
  CHECK(read_attributed(out).properties == position + Words{"char nx", "char ny", "char nz"});
  winnow_ok({"simplify", in, "-o", out, "--faces", "500", "-q", "--force", "--normals"});
  CHECK(read_attributed(out).properties == position + Words{"float nx", "float ny", "float nz"});
}

TEST_CASE("of a name that a file has twice the number of the common type is carried") {
  const Directory directory;
  const AttributedMesh mesh = generated(directory.path(), 4000);
  const auto always = [](double value) { return [value](const Point&) { return value; }; };
  const std::string one = directory.file("one.ply");
  const std::string two = directory.file("two.ply");
  const std::string out = directory.file("out.ply");
  write_attributed(one, mesh, {{"red", NumberType::uint8, always(200)}});
  write_attributed(
      two, mesh,
      {{"red", NumberType::float32, always(1e12)}, {"red", NumberType::uint8, always(200)}});
  for (const Words& inputs : {Words{one, two}, Words{two, one}}) {
    winnow_ok(Words{"simplify"} + inputs + Words{"-o", out, "--faces", "500", "-q", "--force"});
    const std::vector<double> red = read_attributed(out).columns.at("red");
    CHECK(std::all_of(red.begin(), red.end(), [](double value) { return value == 200; }));
  }
}

TEST_CASE("an STL carries nothing and says so") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  write_attributed(in, generated(directory.path(), 4000), usual_columns());
  const Run run =
      winnow_ok({"simplify", in, "-o", directory.file("out.stl"), "--faces", "1k", "--json"});
  CHECK(run.json()["attributes"]["carried"].empty());
  REQUIRE(run.json()["notes"].size() == 1);
  CHECK_THAT(run.json()["notes"][0].get<std::string>(),
             Catch::Contains("red, green, blue, quality, label, stamp"));
}

}  // namespace winnow::test
