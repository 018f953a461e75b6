// The number of threads never changes a byte.
#include "support/simplified.hpp"

namespace winnow::test {

namespace {

void compare_threads(const std::string& format) {
  const Directory directory;
  for (const char* surface : {"scan", "terrain", "part"}) {
    const std::string input = directory.file(surface + ("." + format));
    generate(surface, 40'000, input);
    for (const Words& how : {Words{"--cell", "0.02"}, Words{"--grid", "70"},
                             Words{"--faces", "5000", "--refine", "none"},
                             Words{"--ratio", "20%", "--refine", "none"}}) {
      for (const char* placement : {"mean", "quadric"}) {
        const Words options = how + Words{"--placement", placement};
        INFO(surface << "." << format << " " << joined(options));
        const Simplified one = simplified(directory, input, options + Words{"--threads", "1"});
        CHECK(one.report["output"]["faces"] > 100);
        for (const char* threads : {"2", "4"}) {
          INFO(threads << " threads");
          CHECK(simplified(directory, input, options + Words{"--threads", threads}).hash ==
                one.hash);
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("the same bytes with 1 2 and 4 threads from PLY", "[same_bytes]") {
  compare_threads("ply");
}
TEST_CASE("the same bytes with 1 2 and 4 threads from STL", "[same_bytes]") {
  compare_threads("stl");
}

TEST_CASE("the same STL with 1 2 and 4 threads", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("part.ply");
  generate("part", 40'000, input);
  const Simplified one =
      simplified(directory, input, {"--grid", "70", "--threads", "1"}, {}, "out.stl");
  for (const char* threads : {"2", "4"}) {
    CHECK(
        simplified(directory, input, {"--grid", "70", "--threads", threads}, {}, "out.stl").hash ==
        one.hash);
  }
}

}  // namespace winnow::test
