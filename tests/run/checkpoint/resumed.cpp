// What is resumed, and from where, is told; nothing that was done is done again.
#include "support/checkpoints.hpp"
#include "support/simplified.hpp"

#include <filesystem>

namespace winnow::test {

namespace {

SimplifyOptions to_faces(std::uint64_t faces) {
  SimplifyOptions options;
  options.target = Target::faces(faces);
  return options;
}

struct Interrupted {
  Directory directory;
  std::string input = directory.file("in.ply"), output = directory.file("out.ply");
  SimplifyOptions options = to_faces(6'000);

  Interrupted() { generate("scan", 160'000, input); }

  std::string undisturbed() {
    Context context;
    context.scratch = directory.path();
    simplify(context, input, output, options);
    const std::string hash = hash_of_file(output);
    ::unlink(output.c_str());
    return hash;
  }
};

}  // namespace

TEST_CASE("a run goes on where it was stopped", "[faults]") {
  Interrupted test;
  const std::string want = test.undisturbed();
  const struct {
    const char* stage;
    int time;
    bool clustered;
    std::uint64_t rounds;
  } places[] = {
      {"weld", 1, false, 0}, {"refine", 1, true, 0}, {"refine", 2, true, 0}, {"write", 1, true, 2}};
  for (const auto& place : places) {
    const Checkpoint checkpoint = stopped_at(test.directory, {test.input}, test.output,
                                             test.options, place.stage, place.time);
    // Where the input was read it is needed no more.
    const std::string away = test.directory.file("away.ply");
    if (place.clustered) std::filesystem::rename(test.input, away);
    const SimplifyReport report = resumed(checkpoint);
    if (place.clustered) std::filesystem::rename(away, test.input);
    INFO(place.stage << " " << place.time);
    REQUIRE(report.resumed);
    CHECK(report.resumed->clustered == place.clustered);
    CHECK(report.resumed->rounds >= place.rounds);
    CHECK_FALSE(report.resumed->written);
    CHECK(report.input.faces == 160'000);
    CHECK(report.output.faces == 6'000);
    CHECK(report.refine.tiles > 2);
    CHECK(report.refine.stopped_by == StoppedBy::count);
    CHECK(hash_of_file(test.output) == want);
    CHECK(std::filesystem::is_empty(checkpoint.directory));
    ::unlink(test.output.c_str());
  }
}

TEST_CASE("several files, cropped and written packed, go on to the same bytes", "[faults]") {
  const Directory directory;
  const std::vector<std::string> inputs{directory.file("scan.ply"), directory.file("terrain.stl")};
  generate("scan", 60'000, inputs[0]);
  generate("terrain", 40'000, inputs[1]);
  const std::string output = directory.file("out.glb");
  SimplifyOptions options = to_faces(4'000);
  options.crop = {{{-0.5, -0.5, -10}, {10, 10, 10}}};
  options.encoding.compress = Compression::meshopt;
  Context context;
  const SimplifyReport right = simplify(context, inputs, output, options);
  CHECK(right.input.cropped_faces > 1'000);
  const std::string want = hash_of_file(output);
  ::unlink(output.c_str());
  for (const char* stage : {"weld", "refine"}) {
    const SimplifyReport report = resumed(stopped_at(directory, inputs, output, options, stage));
    INFO(stage);
    CHECK(report.input.cropped_faces == right.input.cropped_faces);
    CHECK(hash_of_file(output) == want);
    ::unlink(output.c_str());
  }
}

TEST_CASE("tiles that were tried are not tried again", "[faults]") {
  Interrupted test;
  const std::string want = test.undisturbed();
  // The first round is stopped when its last tile is through and the mesh of them is to be kept.
  const std::string tried = test.directory.file("kept/round-1.attempt-0");
  Context context;
  context.threads = 2;
  context.progress = [&](const Progress& progress) {
    if (std::string(progress.stage) == "keep" && exists(tried)) context.cancel();
  };
  const Checkpoint checkpoint{test.directory.file("kept")};
  const Error error = error_of(
      [&] { simplify(context, std::vector{test.input}, test.output, test.options, checkpoint); });
  REQUIRE(error.kind() == ErrorKind::cancelled);
  REQUIRE(size_of_file(tried) > 0);
  const SimplifyReport report = resumed(checkpoint);
  CHECK(report.resumed->tiles > 0);
  CHECK(hash_of_file(test.output) == want);
}

TEST_CASE("a checkpoint that is kept writes the output again", "[faults]") {
  Interrupted test;
  Context context;
  const Checkpoint checkpoint{test.directory.file("kept"), true};
  const SimplifyReport first =
      simplify(context, std::vector{test.input}, test.output, test.options, checkpoint);
  const std::string want = hash_of_file(test.output);
  CHECK_FALSE(first.resumed);
  const SimplifyReport done = resume(context, checkpoint);
  CHECK(done.resumed->written);
  CHECK(done.refine.collapses == first.refine.collapses);
  ::unlink(test.output.c_str());
  const SimplifyReport again = resume(context, {checkpoint.directory});
  CHECK_FALSE(again.resumed->written);
  CHECK(again.refine.collapses == first.refine.collapses);
  CHECK(again.cells == first.cells);
  CHECK(again.output.faces == first.output.faces);
  CHECK(hash_of_file(test.output) == want);
  CHECK(std::filesystem::is_empty(checkpoint.directory));
}

}  // namespace winnow::test
