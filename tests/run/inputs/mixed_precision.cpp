// Inputs of doubles and of floats beside each other: a note says that they may not be joined.
#include <winnow/simplify.hpp>

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/notes.hpp"
#include "support/ply_file.hpp"
#include "support/program.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// A strip of squares whose left side is at `from`; no coordinate but 0 is a float.
Polygons strip(double from) {
  Polygons mesh;
  for (int i = 0; i <= 20; ++i) {
    for (const double x : {from, from + 0.1}) mesh.vertices.push_back({x, 0.1 * i, 0.01 * i * i});
  }
  for (std::int64_t i = 0; i < 20; ++i)
    mesh.faces.push_back({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
  return mesh;
}

SimplifyReport beside_each_other(const Directory& directory, std::array<PlyType, 2> types,
                                 const SimplifyOptions& asked) {
  std::vector<std::string> inputs;
  for (std::size_t i = 0; i < 2; ++i) {
    PlyStyle style;
    style.coordinate.fill(types[i]);
    inputs.push_back(directory.file("part-" + std::to_string(i) + ".ply"));
    write_file(inputs.back(), ply_file(strip(static_cast<double>(i) * 0.1), style));
  }
  SimplifyOptions options = asked;
  options.force = true;
  options.target = Target::ratio(1);
  Context context;
  return simplify(context, inputs, directory.file("out.ply"), options);
}

bool tells_of_borders(const SimplifyReport& report) {
  return has_note(report.notes, "may not be joined");
}

constexpr std::uint64_t apart = 4 + 2 * 40;  // sides of two strips
constexpr std::uint64_t together = 4 + 40;

}  // namespace

TEST_CASE("a border between doubles and floats is told of, and joined by --weld") {
  const Directory directory;
  constexpr std::array mixed{PlyType::float64, PlyType::float32};
  const SimplifyReport as_is = beside_each_other(directory, mixed, {});
  CHECK(as_is.topology.output.boundary == apart);
  CHECK(tells_of_borders(as_is));

  SimplifyOptions weld;
  weld.weld = 1e-6;
  const SimplifyReport welded = beside_each_other(directory, mixed, weld);
  CHECK(welded.topology.output.boundary == together);
  CHECK_FALSE(tells_of_borders(welded));

  for (const PlyType type : {PlyType::float32, PlyType::float64}) {
    const SimplifyReport same = beside_each_other(directory, {type, type}, {});
    CHECK(same.topology.output.boundary == together);
    CHECK_FALSE(tells_of_borders(same));
  }
}

}  // namespace winnow::test
