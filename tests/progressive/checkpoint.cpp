// A run that was stopped at any stage goes on from its checkpoint, and ends with the same file.
#include <winnow/checkpoint.hpp>
#include <winnow/error.hpp>

#include "support/job.hpp"
#include "support/program.hpp"
#include "support/progressive.hpp"

namespace winnow::test {

namespace {

// Stops where `stage` begins for the `time`th time.
Checkpoint stopped(ProgressivePlace& place, const std::string& mesh, const std::string& output,
                   const ProgressiveOptions& options, const std::string& stage, int time) {
  Context context;
  context.threads = 2;
  context.progress = [&](const Progress& progress) {
    if (progress.done == 0 && progress.stage == stage && --time == 0) context.cancel();
  };
  const Checkpoint checkpoint{place.directory.file("kept")};
  const Error error = error_of([&] { progressive(context, {mesh}, output, options, checkpoint); });
  INFO(error.what());
  REQUIRE(error.kind() == ErrorKind::cancelled);
  REQUIRE(std::string(error.what()).find("go on by `resume`") != std::string::npos);
  REQUIRE_FALSE(exists(output));
  return checkpoint;
}

}  // namespace

TEST_CASE("a progressive run that was stopped ends with the same file",
          "[progressive][same_bytes]") {
  ProgressivePlace place;
  const std::string mesh = place.directory.file("scan.ply");
  generate("scan", 300'000, mesh);
  ProgressiveOptions options;
  options.bits = 16;
  options.weld = Distance::of_diagonal(1e-6);
  const std::string hash = hash_of_file(place.made(mesh, options, "whole.wpm"));
  const std::uint64_t rounds = place.report.rounds;
  REQUIRE(rounds >= 3);
  const std::string output = place.directory.file("out.wpm");
  struct Stop {
    const char* stage;
    int time;
    std::uint64_t rounds;
  };
  for (const Stop& stop : {Stop{"refine", 1, 0}, Stop{"refine", 2, 1}, Stop{"keep", 3, 1},
                           Stop{"encode", 1, rounds}, Stop{"write", 1, rounds}}) {
    CAPTURE(stop.stage, stop.time);
    const Checkpoint checkpoint = stopped(place, mesh, output, options, stop.stage, stop.time);
    CHECK(call_of(checkpoint) == ResumableCall::progressive);
    CHECK(error_of([&] { resume(place.context, checkpoint); }).kind() == ErrorKind::usage);
    Context context;
    context.threads = 1;
    const ProgressiveReport report = resume_progressive(context, checkpoint);
    CHECK(hash_of_file(output) == hash);
    CHECK(report.output.faces == place.report.output.faces);
    CHECK(report.output.vertices == place.report.output.vertices);
    CHECK(report.collapses == place.report.collapses);
    CHECK(report.rounds == rounds);
    REQUIRE(report.resumed);
    CHECK(report.resumed->clustered);
    CHECK(report.resumed->rounds == stop.rounds);
    CHECK_FALSE(exists(checkpoint.directory + "/manifest"));
    std::filesystem::remove(output);
  }
}

TEST_CASE("a progressive run whose checkpoint is kept is told to be done", "[progressive]") {
  ProgressivePlace place;
  const std::string mesh = place.directory.file("scan.ply");
  generate("scan", 5'000, mesh);
  const std::string output = place.directory.file("out.wpm");
  const Checkpoint checkpoint{place.directory.file("kept"), true};
  const ProgressiveReport made = progressive(place.context, {mesh}, output, {}, checkpoint);
  const std::string hash = hash_of_file(output);
  const ProgressiveReport done = resume_progressive(place.context, checkpoint);
  REQUIRE(done.resumed);
  CHECK(done.resumed->written);
  CHECK(done.output.faces == made.output.faces);
  CHECK(done.output.bytes == made.output.bytes);
  std::filesystem::remove(output);
  CHECK_FALSE(resume_progressive(place.context, checkpoint).resumed->written);
  CHECK(hash_of_file(output) == hash);
  const Checkpoint none{place.directory.file("nothing")};
  CHECK(call_of(none) == ResumableCall::simplify);
  CHECK(error_of([&] { resume_progressive(place.context, none); }).kind() == ErrorKind::bad_input);
}

}  // namespace winnow::test
