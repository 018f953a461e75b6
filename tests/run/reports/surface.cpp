// The report says what surface went in and came out, as `winnow info` counts it, and what became of
// it.
#include "support/simplified.hpp"
#include "support/stl_file.hpp"

namespace winnow::test {

namespace {

struct Told {
  nlohmann::json report, info;

  [[nodiscard]] bool notes(const std::string& words) const {
    return report["notes"].dump().find(words) != std::string::npos;
  }
};

Told told(const Directory& directory, const std::string& input, const Words& options) {
  const std::string output = directory.file("mesh.ply");
  const Run run = winnow_ok(Words{"simplify", input, "-o", output, "--force", "--json"} + options);
  return {run.json(), winnow_ok({"info", output, "--json"}).json()};
}

}  // namespace

TEST_CASE("edges and area are reported as info counts them", "[long]") {
  const Directory directory;
  for (const char* surface : {"scan", "terrain", "part"}) {
    const std::string input = directory.file(surface + std::string(".ply"));
    generate(surface, 40'000, input);
    const nlohmann::json before = winnow_ok({"info", input, "--json"}).json();
    for (const Words& options :
         {Words{"--faces", "3000"}, Words{"--cell", "0.1"},
          Words{"--faces", "2000", "--detail", "3"}, Words{"--faces", "3000", "--refine", "none"},
          Words{"--error", "0.2%"}}) {
      INFO(surface << " " << joined(options));
      const Told one = told(directory, input, options);
      const nlohmann::json& topology = one.report["topology"];
      CHECK(topology["output"]["edges"] == one.info["edges"]["total"]);
      CHECK(topology["output"]["boundary"] == one.info["edges"]["boundary"]);
      CHECK(topology["output"]["non_manifold"] == one.info["edges"]["non_manifold"]);
      CHECK(topology["pieces"]["output"] == one.info["parts"]);
      CHECK(one.report["area"]["output"].get<double>() == Approx(one.info["area"].get<double>()));
      CHECK(one.report["area"]["input"].get<double>() ==
            Approx(before["area"].get<double>()).epsilon(1e-6));
      if (!topology["input"].is_null()) {
        CHECK(topology["input"]["boundary"] == before["edges"]["boundary"]);
        CHECK(topology["input"]["edges"] == before["edges"]["total"]);
        CHECK(topology["pieces"]["input"] == before["parts"]);
      }
      CHECK(topology["input"].is_null() == one.report["clustered"]["first"].get<bool>());
    }
  }
}

TEST_CASE("the report and the plan say whether and why the input is clustered first") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 40'000, input);
  const struct {
    Words options;
    bool first;
    const char* reason;
  } cases[] = {{{"--faces", "3000"}, false, "no more than 1,048,576 faces"},
               {{"--faces", "3000", "--detail", "full"}, false, "--detail full"},
               {{"--faces", "3000", "--detail", "4"}, true, "--detail"},
               {{"--error", "0.1%"}, false, "no more than 1,048,576 faces"},
               {{"--cell", "0.1"}, true, "alone"},
               {{"--faces", "3000", "--refine", "none"}, true, "alone"}};
  for (const auto& one : cases) {
    INFO(joined(one.options));
    const nlohmann::json report = told(directory, input, one.options).report;
    const nlohmann::json plan =
        winnow_ok(Words{"simplify", input, "-o", "none.ply", "--dry-run", "--json"} + one.options)
            .json();
    for (const nlohmann::json& json : {report, plan}) {
      CHECK(json["clustered"]["first"] == one.first);
      CHECK(json["clustered"]["reason"].get<std::string>().find(one.reason) != std::string::npos);
    }
  }
}

TEST_CASE("loose faces get a note that names --weld and one about their area") {
  const Directory directory;
  const std::string soup = directory.file("soup.stl"), scan = directory.file("scan.stl");
  Random random(5);
  write_file(soup, binary_stl(random_triangles(random, 2'000, 1)));
  generate("scan", 5'000, scan);
  const Told loose = told(directory, soup, {"--ratio", "20%"});
  CHECK(loose.notes("--weld"));
  CHECK(loose.notes("of the area is gone"));
  CHECK(loose.report["topology"]["input"]["boundary"] == 6'000);
  CHECK_FALSE(loose.report["topology"]["closed"].get<bool>());
  const Told whole = told(directory, scan, {"--ratio", "50%"});
  CHECK_FALSE(whole.notes("--weld"));
  CHECK_FALSE(whole.notes("of the area is gone"));
  CHECK(whole.report["topology"]["closed"].get<bool>());
}

TEST_CASE("the reported surface is the same for any threads and memory", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 200'000, input);
  for (const Words& options : {Words{"--cell", "0.02"}, Words{"--faces", "20k", "--detail", "4"}}) {
    const Words two = options + Words{"--threads", "2"};
    const Simplified one = simplified(directory, input, options + Words{"--threads", "1"});
    const Simplified small =
        simplified(directory, input, two + Words{"--memory", smallest_memory(input, two)});
    for (const char* part : {"topology", "area", "clustered"})
      CHECK(one.report[part] == small.report[part]);
  }
}

}  // namespace winnow::test
