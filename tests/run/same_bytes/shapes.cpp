// The number of threads changes no byte of any shape: outliers, hubs, soups, faces that cross
// everywhere.
#include "support/shape_files.hpp"
#include "support/simplified.hpp"

namespace winnow::test {

namespace {

// Twice with each: what depends on the order of threads need not show at once.
void check_threads(const Shape& shape, const std::vector<Words>& ways,
                   Numbers numbers = Numbers::floats) {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  write_file(input, ply_of(shape, numbers));
  for (const Words& options : ways) {
    INFO(joined(options));
    const Simplified one = simplified(directory, input, options + Words{"--threads", "1"});
    CHECK(one.report["output"]["faces"] > 0);
    for (const char* threads : {"2", "7"}) {
      for (int time = 0; time < 2; ++time) {
        INFO(threads << " threads");
        const Simplified more = simplified(directory, input, options + Words{"--threads", threads});
        CHECK(more.hash == one.hash);
        for (const char* part : {"input", "output", "refine", "cells", "merged_opposite_faces",
                                 "cell_size", "notes"}) {
          INFO(part);
          CHECK(more.report[part] == one.report[part]);
        }
      }
    }
  }
}

const Words by_count{"--faces", "4000"};
const Words by_error{"--error", "1%"};
const Words clustered_first{"--faces", "2000", "--detail", "4"};
const Words clustered_by_count{"--faces", "4000", "--refine", "none"};
const Words clustered_by_grid{"--grid", "40", "--placement", "mean"};

}  // namespace

TEST_CASE("the same bytes with any threads where a vertex lies far off", "[same_bytes]") {
  // Large enough that every thread has some of it.
  check_threads(shapes::far_vertex(100, 3e7), {by_count});
  check_threads(shapes::far_vertex(100, 1e4), {by_count, {"--cell", "0.05"}});
  check_threads(turned(shapes::far_vertex(70, 3e7), 0.4), {clustered_first, {"--error", "0.01"}},
                Numbers::doubles);
}

TEST_CASE("the same bytes with any threads of faces around one vertex or edge", "[same_bytes]") {
  check_threads(shapes::hub(2000), {{"--faces", "500"}});
  check_threads(shapes::hub(50'000), {clustered_by_grid, clustered_by_count});
  check_threads(shapes::book(300), {{"--faces", "100"}, clustered_by_grid});
}

TEST_CASE("the same bytes with any threads of a soup", "[same_bytes]") {
  check_threads(shapes::soup(30'000, 0.1),
                {by_count, by_error, clustered_by_grid, clustered_first, clustered_by_count});
  check_threads(shapes::jittered_soup(30), {by_count, clustered_by_grid}, Numbers::doubles);
}

TEST_CASE("the same bytes with any threads of non-manifold faces", "[same_bytes]") {
  check_threads(shapes::crowd(20'000, 2000), {by_count, clustered_by_grid});
  check_threads(shapes::double_sided(60), {by_count, by_error, clustered_by_grid, clustered_first});
}

}  // namespace winnow::test
