// Scratch never grows beyond what --dry-run predicts.
#include "support/budget.hpp"

namespace winnow::test {

namespace {

nlohmann::json check_scratch(const Directory& directory, const std::string& input,
                             const Words& options, const Setup& setup = {}) {
  const Words arguments =
      Words{"simplify", input, "-o", directory.file("out.ply"), "--json", "--force"} + options;
  INFO(joined(arguments));
  const nlohmann::json plan = winnow_ok(arguments + Words{"--dry-run"}, setup).json();
  const nlohmann::json report = winnow_ok(arguments, setup).json();
  CHECK(report["peak_scratch_bytes"] > 0);
  CHECK(report["peak_scratch_bytes"] <= plan["scratch_worst"]);
  CHECK(report["peak_scratch_bytes"] <= report["spilled_bytes"]);
  return report;
}

}  // namespace

TEST_CASE("the worst case for scratch is within the prediction", "[budget]") {
  const Directory directory;
  // No shared corners: cells far below the edge length, faces in a scattered order.
  const std::string soup = directory.file("soup.stl");
  generate("scan", 500'000, soup, {.shuffle = true});
  for (const char* placement : {"mean", "quadric"}) {
    const Words options{"--cell", "0.00001", "--threads", "2", "--placement", placement};
    check_scratch(directory, soup, options + Words{"--memory", smallest_memory(soup, options)});
  }
}

TEST_CASE("a copied or kept input is within the prediction", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 2'000'000, input);
  const std::string packed = zstd_file(input);
  check_scratch(directory, packed, {"--cell", "0.02", "--threads", "2", "--memory", "40M"});
  check_scratch(directory, packed,
                {"--faces", "20k", "--refine", "none", "--threads", "2", "--memory", "40M"});
}

TEST_CASE("a coherent scan at a tenth stays far below 40 bytes of scratch a face", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  constexpr std::uint64_t faces = 2'000'000;
  generate("scan", faces, input);
  const Words options{"--ratio", "10%", "--refine", "none", "--threads", "2"};
  const nlohmann::json report =
      check_scratch(directory, input, options + Words{"--memory", smallest_memory(input, options)});
  CHECK(report["peak_scratch_bytes"] <= 40 * faces);
  CHECK(report["spilled_bytes"] <= 40 * faces);
}

TEST_CASE("a dry run foretells the scratch of refinement", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 600'000, input);
  for (const Words& options :
       {Words{"--faces", "30k", "--detail", "full"}, Words{"--ratio", "20%", "--detail", "4"}}) {
    const Words arguments =
        Words{"simplify", input,     "-o",       directory.file("out.ply"),
              "--json",   "--force", "--memory", smallest_memory(input, options)} +
        options;
    const nlohmann::json plan = winnow_ok(arguments + Words{"--dry-run"}).json();
    const double peak = winnow_ok(arguments).json()["peak_scratch_bytes"];
    INFO(joined(options) << " " << plan["scratch_expected"]);
    CHECK(peak > 10e6);
    CHECK(plan["scratch_expected"] > peak / 2);
    CHECK(plan["scratch_expected"] < 2 * peak);
  }
}

}  // namespace winnow::test
