// Several results of one run that was stopped: all of them are made, and none twice.
#include "support/levels.hpp"

#include "support/checkpoints.hpp"
#include "support/program.hpp"

#include <filesystem>

namespace winnow::test {

TEST_CASE("a run to several counts goes on in any of them", "[faults][long]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  const std::string output = directory.file("level-{faces}.ply");
  generate("scan", 160'000, input);
  const SimplifyOptions options =
      to_levels({Target::faces(60'000), Target::faces(12'000), Target::faces(900)});
  Context context;
  context.scratch = directory.path();
  const std::vector<std::string> want = hashes_of_levels(simplify(context, input, output, options));
  const struct {
    const char* stage;
    int time;
  } places[] = {{"weld", 1},  {"refine", 1}, {"write", 1},  {"refine", 3},
                {"write", 2}, {"refine", 4}, {"unfold", 3}, {"write", 3}};
  for (const auto& place : places) {
    INFO(place.stage << " " << place.time);
    const Checkpoint checkpoint =
        stopped_at(directory, {input}, output, options, place.stage, place.time);
    const SimplifyReport report = resumed(checkpoint);
    REQUIRE(report.levels.size() == 3);
    for (const LevelReport& level : report.levels) {
      CHECK(level.target_met == true);
      CHECK(level.refine.collapses > 0);
    }
    CHECK(hashes_of_levels(report) == want);
    CHECK(std::filesystem::is_empty(checkpoint.directory));
  }
}

}  // namespace winnow::test
