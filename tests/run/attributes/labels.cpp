// Whole numbers that tell things apart stay what they are, and numbers for "none" take no part in
// means.
#include <winnow/simplify.hpp>

#include "support/attributes.hpp"
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/program.hpp"

#include <limits>
#include <set>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

double octant(const Point& p) {
  return 3 + 4 * (p[0] > 0) + 90 * (p[1] > 0) + 1000 * (p[2] > 0);
}

std::set<double> values_of(const AttributedMesh& mesh, const std::string& column) {
  const std::vector<double>& all = mesh.columns.at(column);
  return {all.begin(), all.end()};
}

AttributedMesh simplified(const std::string& input, const std::string& output,
                          SimplifyOptions options, unsigned threads = 2) {
  Context context;
  context.threads = threads;
  options.force = true;
  simplify(context, input, output, options);
  return read_attributed(output);
}

std::vector<SimplifyOptions> label_ways() {
  std::vector<SimplifyOptions> ways(4);
  ways[0].target = Target::ratio(0.02);
  ways[1].target = Target::ratio(0.02);
  ways[1].detail = std::numeric_limits<double>::infinity();
  ways[2].target = Target::cell(0.1);
  ways[3].target = Target::error(Distance::of_diagonal(0.003));
  return ways;
}

}  // namespace

TEST_CASE("no label comes out that did not go in", "[long]") {
  const Directory directory;
  const AttributedMesh mesh = generated(directory.path(), 60'000);
  const std::string input = directory.file("in.ply");
  const std::vector<std::pair<std::string, NumberType>> labels{
      {"label", NumberType::int32},
      {"object_id", NumberType::uint32},
      {"classification", NumberType::uint8},
      {"Segment", NumberType::int16},
      {"flags", NumberType::uint16}};
  std::vector<Column> columns;
  for (const auto& [name, type] : labels) {
    const bool small = type == NumberType::uint8;
    columns.push_back(
        {name, type, [small](const Point& p) { return small ? octant(p) / 8 : octant(p); }});
  }
  write_attributed(input, mesh, columns);
  const AttributedMesh before = read_attributed(input);
  for (const SimplifyOptions& options : label_ways()) {
    const AttributedMesh out = simplified(input, directory.file("out.ply"), options);
    for (const auto& [name, type] : labels) {
      CAPTURE(name);
      CHECK(values_of(out, name) == values_of(before, name));
    }
    // Most vertices are still on the side that their label tells.
    std::size_t right = 0;
    for (std::size_t v = 0; v < out.positions.size(); ++v)
      right += out.columns.at("label")[v] == octant(out.positions[v]) ? 1 : 0;
    CHECK(static_cast<double>(right) > 0.9 * static_cast<double>(out.positions.size()));
    const AttributedMesh again = simplified(input, directory.file("again.ply"), options, 7);
    CHECK(again.columns == out.columns);
  }
}

TEST_CASE("a number that says there is no data takes no part in means") {
  const Directory directory;
  const AttributedMesh mesh = generated(directory.path(), 60'000);
  const std::string input = directory.file("in.ply");
  const std::string whole = directory.file("whole.ply");
  const auto height = [](const Point& p) { return p[2]; };
  const auto holes = [](const Point& p) {
    // A large part has none, and single vertices here and there.
    return p[0] > 0.3 || (static_cast<int>(1e5 * p[1]) & 3) == 0 ? -9999 : p[2];
  };
  write_attributed(input, mesh,
                   {{"height", NumberType::float32, holes}, {"exact", NumberType::float64, holes}});
  write_attributed(
      whole, mesh,
      {{"height", NumberType::float32, height}, {"exact", NumberType::float64, height}});
  for (SimplifyOptions options : label_ways()) {
    options.nodata = -9999;
    const AttributedMesh out = simplified(input, directory.file("out.ply"), options);
    std::size_t none = 0;
    std::size_t lost = 0;
    std::size_t there = 0;
    for (std::size_t v = 0; v < out.positions.size(); ++v) {
      for (const char* column : {"height", "exact"}) {
        const double value = out.columns.at(column)[v];
        none += value == -9999 ? 1 : 0;
        if (value != -9999) CHECK(std::abs(value - out.positions[v][2]) < 0.3);
        if (out.positions[v][0] > 0.6) CHECK(value == -9999);
        if (out.positions[v][0] < 0) ++(value == -9999 ? lost : there);
      }
    }
    CHECK(none > 0);
    // A quarter of the vertices has none, but few that many became one of.
    if (!options.target.error()) CHECK(lost < there / 20);
  }
}

}  // namespace winnow::test
