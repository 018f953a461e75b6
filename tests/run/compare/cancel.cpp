// A comparison is cancelled in every stage, and then within a second; nothing is left.
#include <winnow/compare.hpp>
#include <winnow/error.hpp>

#include "base/progress.hpp"
#include "support/job.hpp"
#include "support/sanitized.hpp"
#include "support/simplified.hpp"

#include <set>

namespace winnow::test {

namespace {

struct Outcome {
  int code = 0;
  double seconds = 0;  // from the wish to the end
};

}  // namespace

TEST_CASE("a comparison is cancelled in every stage", "[faults]") {
  const Directory directory;
  const std::string original = directory.file("scan.ply");
  const std::string small = directory.file("small.ply");
  generate("scan", 60'000, original);
  winnow_ok({"simplify", original, "-o", small, "--faces", "3k", "-q"});
  const Words before = directory.names();
  CompareOptions options;
  options.samples = 20'000;
  options.colored = directory.file("colored.ply");
  options.picture = directory.file("picture.png");
  const auto run = [&](const std::string& stage, std::set<std::string>* stages) {
    Context context;
    context.threads = 2;
    context.scratch = directory.path();
    Outcome outcome;
    Stopwatch since;
    context.progress = [&](const Progress& progress) {
      if (stages != nullptr) stages->insert(progress.stage);
      if (progress.stage != stage) return;
      since = {};
      context.cancel();
    };
    try {
      compare(context, original, small, options);
    } catch (const Error& error) {
      outcome = {error.exit_code(), since.seconds()};
    }
    return outcome;
  };
  std::set<std::string> stages;
  CHECK(run("", &stages).code == 0);
  CHECK(stages.size() >= 4);
  ::unlink(options.colored.c_str());
  ::unlink(options.picture.c_str());
  for (const std::string& stage : stages) {
    INFO(stage);
    const Outcome outcome = run(stage, nullptr);
    CHECK(outcome.code == 130);
    CHECK(outcome.seconds < 1 * patience);
    CHECK(directory.names() == before);
  }
}

TEST_CASE("one face with all samples does not keep a comparison from stopping", "[faults]") {
  const Directory directory;
  const std::string mesh = directory.file("mesh.stl");
  generate("terrain", 8, mesh);
  Context context;
  context.threads = 1;
  context.scratch = directory.path();
  CompareOptions options;
  options.samples = 30'000'000;
  const std::jthread later = cancel_later(context, std::chrono::milliseconds(500));
  const Stopwatch watch;
  int code = 0;
  try {
    compare(context, mesh, mesh, options);
  } catch (const Error& error) {
    code = error.exit_code();
  }
  CHECK(code == 130);
  CHECK(watch.seconds() < 1.5 * patience);
}

}  // namespace winnow::test
