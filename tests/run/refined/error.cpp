// With --error the result is as near to the original as was asked for, and larger errors leave
// fewer faces.
#include "support/program.hpp"
#include "support/refined_file.hpp"

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

void check_errors(const std::string& input) {
  const Directory directory;
  double diagonal = 0;
  {
    TestJob test;
    Box box;
    for (const IndexedVertex& vertex : plain(welded(test.job, input)).vertices)
      box.add(vertex.position);
    diagonal = box.diagonal();
  }
  std::uint64_t faces = UINT64_MAX;
  for (const double share : {1e-4, 4e-4, 2e-3}) {
    SimplifyOptions options;
    options.target = Target::error(share * diagonal);
    const RefinedFile out = refine_file(directory, input, options);
    CompareOptions how;
    how.samples = 100'000;
    Context context;
    context.scratch = directory.path();
    const CompareReport compared = compare(context, input, out.path, how);
    CAPTURE(input, share, out.report.output.faces, compared.forward.rms, compared.backward.rms);
    CHECK(compared.symmetric.rms < options.target.error()->value);
    CHECK(compared.forward.rms < options.target.error()->value);
    CHECK(compared.backward.rms < options.target.error()->value);
    // And it makes use of what it may: else any mesh would do.
    CHECK(compared.symmetric.rms > options.target.error()->value / 10);
    CHECK(out.report.output.faces < faces);
    CHECK(out.report.refine.stopped_by == StoppedBy::error);
    CHECK(out.report.refine.max_error <= options.target.error()->value * (1 + 1e-9));
    CHECK(out.report.refine.max_error > options.target.error()->value / 2);
    CHECK_FALSE(out.report.target_faces);
    CHECK(compared.topology.duplicate + compared.topology.degenerate == 0);
    faces = out.report.output.faces;
  }
}

}  // namespace

TEST_CASE("a cranium stays within its error", "[long]") {
  check_errors(whale());
}
TEST_CASE("an elevation tile stays within its error", "[slow][long]") {
  check_errors(mountains());
}
TEST_CASE("a generated scan stays within its error", "[long]") {
  const Directory directory;
  const std::string scan = directory.file("scan.ply");
  generate("scan", 150'000, scan);
  check_errors(scan);
}

TEST_CASE("an input that is clustered first stays within its error", "[long]") {
  // Beyond 2^20 faces.
  const Directory directory;
  const std::string scan = directory.file("scan.ply");
  generate("scan", 1'200'000, scan);
  SimplifyOptions options;
  options.target = Target::error(0.004);
  const RefinedFile out = refine_file(directory, scan, options);
  CHECK(out.report.cell_size > 0);
  CompareOptions how;
  how.samples = 100'000;
  Context context;
  context.scratch = directory.path();
  CHECK(compare(context, scan, out.path, how).symmetric.rms < options.target.error()->value);
}

}  // namespace winnow::test
