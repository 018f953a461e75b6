// What vertices carry outlives a run that is killed.
#include "support/attributes.hpp"
#include "support/checkpoints.hpp"

namespace winnow::test {

namespace {

void check_resumed(const SimplifyOptions& options) {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  const std::string output = directory.file("out.ply");
  write_attributed(input, generated(directory.path(), 160'000), usual_columns());
  Context context;
  const SimplifyReport right = simplify(context, input, output, options);
  CHECK(right.refine.tiles > 1);
  const std::string want = hash_of_file(output);
  ::unlink(output.c_str());
  const struct {
    const char* stage;
    int time;
  } places[] = {{"measure attributes", 1}, {"refine", 1}, {"refine", 2}, {"write", 1}};
  for (const auto& place : places) {
    INFO(place.stage << " " << place.time);
    const SimplifyReport report =
        resumed(stopped_at(directory, {input}, output, options, place.stage, place.time));
    CHECK(hash_of_file(output) == want);
    CHECK(report.attributes.carried == right.attributes.carried);
    CHECK(report.attributes.dropped == right.attributes.dropped);
    CHECK(report.notes == right.notes);
    ::unlink(output.c_str());
  }
}

}  // namespace

TEST_CASE("a run with attributes goes on to the same bytes", "[faults]") {
  SimplifyOptions options;
  options.target = Target::faces(6'000);
  check_resumed(options);
}

TEST_CASE("a run with named attributes and an error to reach goes on to the same bytes",
          "[faults][long]") {
  SimplifyOptions options;
  options.target = Target::error(Distance::of_diagonal(0.001));
  options.attributes = {"colors", "stamp"};
  check_resumed(options);
}

}  // namespace winnow::test
