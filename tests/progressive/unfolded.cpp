// What is extracted has its flipped faces turned over, but as it is in the file where it is asked
// for, and at full count.
#include <winnow/compare.hpp>

#include "meshes.hpp"
#include "support/progressive.hpp"

namespace winnow::test {

namespace {

CompareReport judged(Context& context, const std::string& original, const std::string& level) {
  CompareOptions options;
  options.samples = 300'000;
  return compare(context, original, level, options);
}

}  // namespace

TEST_CASE("extracted levels have fewer flipped faces than the file", "[progressive][long]") {
  const std::string mesh = large_mesh("A_classic/dragon_vrip_ascii.ply");
  if (mesh.empty()) return;
  ProgressivePlace place;
  const std::string file = place.made(mesh);
  for (const double ratio : {0.1, 0.01}) {
    place.raw = true;
    const CompareReport raw =
        judged(place.context, mesh, place.extracted(file, Target::ratio(ratio), "raw.ply"));
    place.raw = false;
    const CompareReport level =
        judged(place.context, mesh, place.extracted(file, Target::ratio(ratio)));
    CAPTURE(ratio, raw.topology.flipped, level.topology.flipped);
    CHECK(raw.topology.flipped > 10);
    CHECK(level.topology.flipped < raw.topology.flipped);
    CHECK(level.symmetric.rms <= 1.01 * raw.symmetric.rms);
  }
}

}  // namespace winnow::test
