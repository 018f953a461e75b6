// A run that was stopped writes the map that it would have written.
#include "support/checkpoints.hpp"
#include "support/files.hpp"
#include "support/program.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

namespace winnow::test {

TEST_CASE("a run that goes on writes the same map", "[map][long]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  const std::string output = directory.file("out.ply");
  generate("scan", 160'000, input);
  SimplifyOptions options;
  options.map = directory.file("map.npy");
  Context context;
  context.scratch = directory.path();
  for (const Target target : {Target::faces(40'000), Target::faces(2'000)}) {
    options.target = target;
    simplify(context, input, output, options);
    const std::string mesh = hash_of_file(output);
    const std::string map = hash_of_file(options.map);
    std::filesystem::remove(output);
    std::filesystem::remove(options.map);
    const struct {
      const char* stage;
      int time;
    } places[] = {
        {"map vertices", 1}, {"refine", 1}, {"refine", 2}, {"write", 1}, {"write map", 1}};
    for (const auto& place : places) {
      INFO(place.stage << " " << place.time);
      const Checkpoint checkpoint =
          stopped_at(directory, {input}, output, options, place.stage, place.time);
      CHECK_FALSE(std::filesystem::exists(options.map));
      resumed(checkpoint);
      CHECK(hash_of_file(output) == mesh);
      CHECK(hash_of_file(options.map) == map);
      CHECK(std::filesystem::is_empty(checkpoint.directory));
      std::filesystem::remove(output);
      std::filesystem::remove(options.map);
    }
  }
}

}  // namespace winnow::test
