// A result is the same with next to no memory.
#include "support/clustering.hpp"
#include "support/sanitized.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// The least that the plan may give.
ClusterStyle smallest(unsigned threads, std::size_t parts, bool quadrics) {
  ClusterStyle style;
  style.threads = threads;
  style.memory = {ClusterMemory::smallest_table(parts, quadrics),
                  threads * ClusterMemory::smallest_faces_per_thread, 0, 0, parts};
  return style;
}

}  // namespace

TEST_CASE("tables, faces and results that spill give the same mesh", "[threads]") {
  Random random(500);
  // Nearly every corner in a cell of its own, and a surface whose cells come again.
  std::vector<Triangle> faces = soup(random, 80'000, 0.02);
  std::vector<Triangle> again = ball(160, 0.1);
  for (const auto& [name, mesh, cell] :
       {std::tuple{"soup", &faces, 0.004}, std::tuple{"ball", &again, 0.012}}) {
    for (const Placement placement : {Placement::quadric, Placement::mean}) {
      if (sanitized && placement == Placement::mean) continue;  // has no code of its own here
      const bool quadrics = placement == Placement::quadric;
      const ClusterSettings settings = settings_over(*mesh, cell, placement);
      const PlainMesh right =
          cluster(*mesh, settings, {.memory = {1 << 28, 1 << 26, 1 << 26, 1 << 26, 16}});
      REQUIRE(right.faces.size() > 10'000);
      for (const auto& [threads, ask] :
           {std::pair{1U, true}, std::pair{3U, true}, std::pair{3U, false}}) {
        ClusterStyle style = smallest(threads, ask ? 1 : 4, quadrics);
        style.ask_to_spill = ask;
        style.batches = &random;
        const PlainMesh spilled = cluster(*mesh, settings, style);
        CAPTURE(name, quadrics, threads, ask);
        // Of a soup nearly all sides of faces are boundaries, and spill before all else.
        CHECK(spilled.spilled > right.spilled + 500'000);
        REQUIRE(difference(spilled, right) == "");
        CHECK(spilled.counts.faces == right.counts.faces);
      }
    }
  }
}

TEST_CASE("each share that is too small spills alone") {
  Random random(501);
  const std::vector<Triangle> faces = soup(random, 100'000, 0.02);
  ClusterSettings settings = settings_over(faces, 0.004);
  settings.for_refinement = true;  // without the sides of faces, which spill before all else here
  const ClusterMemory large{1 << 28, 1 << 26, 1 << 26, 1 << 26, 16};
  const PlainMesh right = cluster(faces, settings, {.memory = large});
  REQUIRE(right.spilled == 0);
  for (int share = 0; share < 4; ++share) {
    ClusterMemory memory = large;
    if (share == 0) memory.table = 1 << 22;
    if (share == 1) memory.faces = 1 << 21;
    if (share == 2) memory.vertices = 1 << 20;
    if (share == 3) memory.result = 1 << 20;
    const PlainMesh spilled = cluster(faces, settings, {.memory = memory, .threads = 1});
    CAPTURE(share);
    CHECK(spilled.spilled > 0);
    CHECK(difference(spilled, right) == "");
  }
}

}  // namespace winnow
