// Context::cancel in every stage of a run, at its very beginning: Error(cancelled), and nothing is
// left.
#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "support/job.hpp"
#include "support/simplified.hpp"

#include <set>

namespace winnow::test {

namespace {

using Stages = std::set<std::string>;

void check_every_stage(const Directory& directory, const std::string& input,
                       const SimplifyOptions& options, const Stages& expected,
                       std::uint64_t mebibytes = 40) {
  const std::string output = directory.file("out.ply");
  Context context;
  context.threads = 2;
  context.memory = mebibytes << 20;
  context.scratch = directory.path();
  context.map_input = true;
  Stages stages;
  context.progress = [&](const Progress& progress) { stages.insert(progress.stage); };
  winnow::simplify(context, input, output, options);
  ::unlink(output.c_str());
  CHECK(stages == expected);
  const Words before = directory.names();
  for (const std::string& stage : stages) {
    Context again;
    again.threads = 2;
    again.memory = context.memory;
    again.scratch = directory.path();
    again.map_input = true;
    again.progress = [&](const Progress& progress) {
      if (progress.stage == stage) again.cancel();
    };
    int code = 0;
    try {
      simplify(again, input, output, options);
    } catch (const Error& error) {
      code = error.exit_code();
    }
    INFO(input << ", cancelled in stage '" << stage << "'");
    CHECK(code == 130);
    CHECK(directory.names() == before);
  }
}

SimplifyOptions with_cell() {
  SimplifyOptions options;
  options.target = Target::cell(0.002);
  return options;
}

SimplifyOptions with_grid() {
  SimplifyOptions options;
  options.target = Target::grid(300);
  return options;
}

SimplifyOptions with_ratio() {
  SimplifyOptions options;
  options.target = Target::ratio(0.5);
  options.refine = Refine::none;
  return options;
}

SimplifyOptions refined() {
  SimplifyOptions options;
  options.target = Target::faces(20'000);
  return options;
}

SimplifyOptions refined_after_welding() {
  SimplifyOptions options = refined();
  options.weld = Distance::of_diagonal(0.0005);
  return options;
}

SimplifyOptions refined_after_clustering() {
  SimplifyOptions options;
  options.target = Target::ratio(0.1);
  options.detail = 3;
  return options;
}

SimplifyOptions refined_to_error() {
  SimplifyOptions options;
  options.target = Target::error(0.003);
  return options;
}

SimplifyOptions with_faces() {
  SimplifyOptions options;
  options.target = Target::faces(20'000);
  options.refine = Refine::none;
  return options;
}

}  // namespace

TEST_CASE("a run is cancelled in every stage", "[faults][threads]") {
  const Directory directory;
  const std::string ply = directory.file("scan.ply");
  generate("scan", 40'000, ply);
  const std::string stl = directory.file("scan.stl");
  generate("scan", 40'000, stl);
  const std::string packed_ply = gzip_file(ply);
  const std::string packed_stl = zstd_file(stl);
  check_every_stage(directory, ply, with_cell(), {"cluster", "check", "write"});
  check_every_stage(directory, stl, with_grid(), {"measure", "cluster", "check", "write"});
  check_every_stage(directory, ply, with_faces(), {"sample", "cluster", "check", "write"});
  check_every_stage(directory, packed_ply, with_cell(),
                    {"read vertices", "cluster", "check", "write"});
  check_every_stage(directory, packed_stl, with_faces(),
                    {"copy the input to scratch", "sample", "cluster", "check", "write"});
  check_every_stage(directory, ascii_file(stl, directory.file("ascii.stl")), with_ratio(),
                    {"count faces", "sample", "cluster", "check", "write"});
  check_every_stage(directory, faces_first_file(ply, directory.file("faces-first.ply")),
                    with_cell(), {"keep faces", "cluster", "check", "write"});
}

// Under the thread sanitizer the stages of their own are cancelled in tests/read.
TEST_CASE("a run over faces that jump is cancelled in every stage", "[faults]") {
  const Directory directory;
  const std::string ply = directory.file("scan.ply");
  generate("scan", 1'500'000, ply, {.shuffle = true});
  SimplifyOptions coarse = with_cell();
  coarse.target = Target::cell(0.05);
  check_every_stage(directory, ply, coarse, {"sort faces", "cluster", "check", "write"});
  coarse.strict = true;
  check_every_stage(directory, ply, coarse,
                    {"sort corners", "look up corners", "cluster", "check", "write"});
}

TEST_CASE("a run that refines is cancelled in every stage", "[faults][threads][long]") {
  const Directory directory;
  // Several tiles, so that there is a log to be cut, and a second round.
  const std::string ply = directory.file("scan.ply");
  generate("scan", 200'000, ply);
  check_every_stage(directory, ply, refined(),
                    {"measure", "weld", "join faces", "refine", "unfold", "check", "write"});
  check_every_stage(directory, ply, refined_after_clustering(),
                    {"sample", "cluster", "look for damage", "read near damage", "split cells",
                     "refine", "unfold", "check", "write"});
  check_every_stage(directory, ply, refined_after_welding(),
                    {"measure", "gather vertices", "find neighbours", "join vertices",
                     "count faces", "weld", "join faces", "refine", "unfold", "check", "write"},
                    60);
  check_every_stage(directory, ply, refined_to_error(),
                    {"measure", "weld", "join faces", "refine", "check", "write"});
}

TEST_CASE("a run that refines is cancelled in its second round", "[faults][threads]") {
  const Directory directory;
  const std::string ply = directory.file("scan.ply");
  generate("scan", 200'000, ply);
  Context context;
  context.threads = 2;
  context.memory = std::uint64_t{40} << 20;
  context.scratch = directory.path();
  // Each round begins at none done.
  int rounds = 0;
  context.progress = [&](const Progress& progress) {
    if (std::string_view(progress.stage) != "refine" || progress.done != 0) return;
    if (++rounds == 2) context.cancel();
  };
  const Error error =
      error_of([&] { simplify(context, ply, directory.file("out.ply"), refined()); });
  CHECK(error.exit_code() == 130);
  CHECK(rounds == 2);
  CHECK(directory.names() == Words{"scan.ply"});
}

TEST_CASE("a context that was cancelled before does nothing", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 2'000, input);
  Context context;
  context.cancel();
  CHECK_THROWS_AS(simplify(context, input, directory.file("out.ply"), with_grid()), Error);
  CHECK(directory.names() == Words{"scan.ply"});
}

}  // namespace winnow::test
