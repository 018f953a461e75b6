// Every file of the corpora, as it is, cut, and with a few bytes changed. What fuzzing (tools/fuzz)
// finds is added.
#include "fuzz/targets.hpp"
#include "support/files.hpp"
#include "support/random.hpp"
#include "support/sanitized.hpp"

#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

namespace winnow::fuzz {

namespace {

std::vector<std::string> corpus_of(const Target& target) {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(WINNOW_FUZZ_CORPUS) + "/" + target.name))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

// With one to four of its bytes changed, or some taken out or put in.
std::string changed(std::string bytes, test::Random& random) {
  for (std::uint64_t i = random.between(1, 4); i > 0 && !bytes.empty(); --i) {
    const std::size_t at = random.below(bytes.size());
    const char byte = random.chance(0.5) ? static_cast<char>(random.below(256))
                                         : bytes[random.below(bytes.size())];
    if (random.chance(0.7)) {
      bytes[at] = byte;
    } else if (random.chance(0.5)) {
      bytes.erase(at, random.between(1, 8));
    } else {
      bytes.insert(at, random.between(1, 3), byte);
    }
  }
  return bytes;
}

}  // namespace

TEST_CASE("the corpora of fuzzing are survived, changed and cut too", "[fuzz]") {
  test::Random random(11);
  for (const Target& target : targets()) {
    const std::vector<std::string> files = corpus_of(target);
    REQUIRE(files.size() > 1);
    const auto run = [&](const std::string& bytes) { target.run(std::as_bytes(std::span(bytes))); };
    for (const std::string& file : files) {
      INFO(file);
      const std::string bytes = test::bytes_of_file(file);
      REQUIRE_NOTHROW(run(bytes));
      for (int i = 0; i < (test::sanitized ? 10 : 60); ++i) {
        REQUIRE_NOTHROW(run(changed(bytes, random)));
        REQUIRE_NOTHROW(run(bytes.substr(0, random.below(bytes.size() + 1))));
      }
    }
  }
}

}  // namespace winnow::fuzz
