// A budget that turns out too small while a mesh is refined: the message names one that is enough.
#include "support/attributes.hpp"
#include "support/budget.hpp"
#include "support/shapes.hpp"

namespace winnow::test {

namespace {

// Runs in the smallest budget that the plan names. Where that is refused, the one that is named
// then works.
bool is_refused(const Shape& shape, const Words& options, bool with_attributes = false) {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  write_attributed(input, {shape.vertices, shape.faces, {}, {}},
                   with_attributes ? usual_columns() : std::vector<Column>{});
  const std::string smallest = smallest_memory(input, options);
  INFO(joined(options) << " --memory " << smallest);
  const Words command =
      Words{"simplify", input, "-o", directory.file("out.ply"), "--json"} + options;
  const Run first = run_winnow(command + Words{"--memory", smallest});
  INFO(first.err);
  if (first.code == 0) return false;
  const std::string named = named_memory(first);
  check_peak(run_winnow(command + Words{"--memory", named}), named);
  return true;
}

// More than there are: nothing is collapsed, but the tiles need their room all the same.
const Words all_faces{"--faces", "10M"};

}  // namespace

TEST_CASE("the smallest budget of the plan is enough for a surface", "[budget]") {
  for (const Words& options : {Words{"--faces", "50k"}, Words{"--error", "0.0001"}}) {
    for (const char* threads : {"1", "3"}) {
      CHECK_FALSE(is_refused(shapes::hills(300), options + Words{"--threads", threads}));
      CHECK_FALSE(is_refused(shapes::hills(300), options + Words{"--threads", threads}, true));
    }
  }
}

// Where the smallest budget is too small, is_refused() runs the command again with the one that is
// named, and checks that it works.
TEST_CASE("a budget that is named works for dust and for very many faces around a vertex",
          "[budget]") {
  unsigned refused = 0;
  for (const char* threads : {"1", "4"}) {
    refused += is_refused(shapes::soup(100'000, 0.01), {"--faces", "50k", "--threads", threads});
    refused += is_refused(shapes::hub(300'000), all_faces + Words{"--threads", threads});
  }
  CHECK(refused > 0);
}

TEST_CASE("a budget too small for faces longer than tiles names one that works", "[budget]") {
  CHECK(is_refused(shapes::soup(300'000, 1), {"--error", "0.001"}));
  CHECK(is_refused(shapes::soup(300'000, 1), {"--faces", "3000"}, true));
}

}  // namespace winnow::test
