// Distances of --weld that cannot be are usage errors before anything is read.
#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "support/job.hpp"
#include "support/not_finite.hpp"
#include "support/simplified.hpp"

namespace winnow::test {

TEST_CASE("distances to weld that cannot be are refused by name", "[weld]") {
  Context context;
  const auto refused = [&](const Distance& distance) {
    SimplifyOptions options;
    options.target = Target::faces(100);
    options.weld = distance;
    const Error error = error_of([&] { simplify(context, "none.ply", "small.ply", options); });
    CAPTURE(error.what());
    CHECK(error.kind() == ErrorKind::usage);
    CHECK(std::string(error.what()).find("`weld`") != std::string::npos);
  };
  for (const double length : {0.0, -1.0, nan, infinity}) refused(length);
  for (const double part : {0.0, -0.1, 1.0, nan, infinity}) refused(Distance::of_diagonal(part));
}

TEST_CASE("the command line takes a length or a percentage to weld", "[weld]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 2'000, input);
  for (const char* wrong : {"0", "-1", "1mm", "100%", "nan"}) {
    const Run run =
        run_winnow({"simplify", input, "-o", "none.ply", "--faces", "100", "--weld", wrong});
    INFO(wrong << ": " << run.err);
    CHECK(run.code == 2);
    CHECK(run.err.find("--weld") != std::string::npos);
  }
  CHECK(simplified(directory, input, {"--faces", "500", "--weld", "1e-9"}).hash ==
        simplified(directory, input, {"--faces", "500"}).hash);
}

TEST_CASE("the plan names the passes and the memory of --weld", "[weld]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 2'000, input);
  const Run run = winnow_ok({"simplify", input, "-o", "none.ply", "--faces", "100", "--weld", "1%",
                             "--dry-run", "--json"});
  const nlohmann::json plan = run.json();
  CHECK(plan["passes"].dump().find("near each other") != std::string::npos);
  CHECK(plan["memory"].contains("vertices that --weld moved"));
}

}  // namespace winnow::test
