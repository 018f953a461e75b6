// A comparison says the same for every number of threads, every budget, file or pipe.
#include "support/simplified.hpp"

namespace winnow::test {

namespace {

nlohmann::json compared(const Words& arguments, const Setup& setup = {}) {
  nlohmann::json report =
      winnow_ok(Words{"compare", "--json", "--samples", "30k"} + arguments, setup).json();
  report.erase("seconds");
  report.erase("peak_memory_bytes");
  report.erase("options");
  for (const char* mesh : {"original", "simplified"}) report[mesh].erase("file");
  return report;
}

}  // namespace

TEST_CASE("a comparison is the same for any threads and budget", "[same_bytes]") {
  const Directory directory;
  const std::string small = directory.file("small.ply");
  for (const char* name : {"scan.ply", "scan.stl"}) {
    const std::string original = directory.file(name);
    generate("scan", 600'000, original);
    winnow_ok({"simplify", original, "-o", small, "--faces", "5k", "--force"});
    const nlohmann::json one = compared({original, small, "--threads", "1", "--memory", "2G"});
    CHECK(one["distance"]["symmetric"]["rms"] > 0);
    CHECK(compared({original, small, "--threads", "2", "--memory", "2G"}) == one);
    // The original comes in many parts.
    CHECK(compared({original, small, "--threads", "2", "--memory", "96M"}) == one);
    CHECK(compared({"-", small}, {.in = original}) == one);
    CHECK(compared({original, "-"}, {.in = small}) == one);
  }
}

TEST_CASE("the colored mesh and the picture are the same for any threads and budget",
          "[same_bytes]") {
  const Directory directory;
  const std::string original = directory.file("scan.ply");
  const std::string small = directory.file("small.ply");
  const std::string colored = directory.file("colored.ply");
  const std::string picture = directory.file("picture.png");
  generate("scan", 300'000, original);
  winnow_ok({"simplify", original, "-o", small, "--faces", "3k"});
  const auto hash = [&](const Words& options) {
    winnow_ok(Words{"compare", original, small, "--colored", colored, "--picture", picture,
                    "--force", "-q"} +
              options);
    return hash_of_file(colored) + hash_of_file(picture);
  };
  const std::string one = hash({"--threads", "1"});
  CHECK(hash({"--threads", "2"}) == one);
  CHECK(hash({"--threads", "2", "--memory", "128M"}) == one);
  CHECK(bytes_of_file(picture).substr(1, 3) == "PNG");
  const nlohmann::json info = winnow_ok({"info", colored, "--json"}).json();
  CHECK(info["faces"] == winnow_ok({"info", small, "--json"}).json()["faces"]);
}

}  // namespace winnow::test
