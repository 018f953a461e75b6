// The result does not depend on the order of faces, on how they are cut into batches, on threads.
#include "support/clustering.hpp"
#include "support/sanitized.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

struct Example {
  std::string name;
  std::vector<Triangle> faces;
  double cell;
};

std::vector<Example> examples() {
  Random random(430);
  std::vector<Example> all{{"ball", ball(100, 0.1), 0.05},
                           {"fine ball", ball(60), 0.011},
                           {"soup", soup(random, 20'000, 0.1), 0.1},
                           {"dense soup", soup(random, 20'000, 0.5), 0.3},
                           {"cube", cube(40), 0.07}};
  // Faces folded onto each other: windings must not depend on who came first.
  std::vector<Triangle> folded = sheet(50);
  for (const Triangle& face : sheet(50)) folded.push_back(random.chance(0.5) ? face : turned(face));
  all.push_back({"folded", folded, 0.04});
  return all;
}

}  // namespace

TEST_CASE("clusters do not depend on order, batches and threads", "[threads]") {
  Random random(431);
  for (const Example& example : examples()) {
    for (const Placement placement : {Placement::mean, Placement::quadric}) {
      const ClusterSettings settings = settings_over(example.faces, example.cell, placement);
      const PlainMesh right = cluster(example.faces, settings, {.threads = 1});
      REQUIRE(right.faces.size() > 100);
      CHECK(difference(cluster(example.faces, settings, {.threads = 1}), right) == "");
      std::vector<Triangle> faces = example.faces;
      for (int round = 0; round < (sanitized ? 1 : 2); ++round) {
        random.shuffle(faces);
        for (const unsigned threads : {1U, 2U, 5U}) {
          ClusterStyle style{.threads = threads, .batches = &random};
          style.memory.table_parts = random.one_of<std::size_t>({1, 4, 16, 256});
          const PlainMesh mesh = cluster(faces, settings, style);
          CAPTURE(example.name, static_cast<int>(placement), round, threads);
          REQUIRE(difference(mesh, right) == "");
        }
      }
    }
  }
}

TEST_CASE("clusters of floats are those of the doubles that they are") {
  for (const Example& example : examples()) {
    const std::vector<Triangle> faces = as_floats(example.faces);
    const ClusterSettings settings = settings_over(faces, example.cell, Placement::quadric);
    CAPTURE(example.name);
    CHECK(difference(cluster(faces, settings, {.single = true}), cluster(faces, settings)) == "");
  }
}

}  // namespace winnow
