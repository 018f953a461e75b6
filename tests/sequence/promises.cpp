// The same bytes and a hard budget, of sequences cut into many tiles.
#include "support/budget.hpp"
#include "support/moving_sheet.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

constexpr std::size_t frames = 40;

Words call(const Directory& directory, const Words& names) {
  Words words{"sequence"};
  return words + names +
         Words{"-o", directory.file("s-{frame}.ply"), "--json", "--force", "--ratio", "10%"};
}

std::string hashes(const Directory& directory) {
  std::string all;
  for (std::size_t t = 0; t < frames; ++t)
    all += hash_of_file(directory.file("s-" + std::to_string(t) + ".ply"));
  return all;
}

}  // namespace

TEST_CASE("a sequence gives the same bytes with any threads and memory", "[same_bytes]") {
  const Directory directory;
  const Words names = write_frames(directory, {150}, frames);
  const Run first = winnow_ok(call(directory, names) + Words{"--threads", "1", "--memory", "2G"});
  CHECK(first.json()["output"]["faces"] <= 4500);
  CHECK(first.json()["output"]["faces"] >= 4499);
  CHECK(first.json()["refine"]["tiles"] > 1);
  CHECK(first.json()["spilled_bytes"] == 0);
  const std::string hash = hashes(directory);
  const Words threads = call(directory, names) + Words{"--threads", "3"};
  CHECK(winnow_ok(threads).code == 0);
  CHECK(hashes(directory) == hash);
  // Texts and compressed text are read otherwise.
  Words packed;
  for (const std::string& name : names) {
    packed.push_back(zstd_file(name));
    std::filesystem::remove(name);
  }
  CHECK(winnow_ok(call(directory, packed)).code == 0);
  CHECK(hashes(directory) == hash);
  const std::string memory = enough_memory(call(directory, packed));
  INFO(memory);
  CHECK(hashes(directory) == hash);
}

TEST_CASE("all frames in one GLB are the same bytes with any threads and memory", "[same_bytes]") {
  const Directory directory;
  const Words names = write_frames(directory, {100}, frames);
  const std::string all = directory.file("all.glb");
  const Words into{"-o", all, "--json", "--force", "--ratio", "10%"};
  CHECK(winnow_ok(Words{"sequence"} + names + into + Words{"--threads", "1"}).code == 0);
  const std::string hash = hash_of_file(all);
  CHECK(winnow_ok(Words{"sequence"} + names + into + Words{"--threads", "3"}).code == 0);
  CHECK(hash_of_file(all) == hash);
  const std::string memory = enough_memory(Words{"sequence"} + names + into);
  INFO(memory);
  CHECK(hash_of_file(all) == hash);
  // And as an input, packed as well.
  const std::string small = directory.file("small.glb");
  const Words again{"-o", small, "--json", "--force", "--ratio", "50%"};
  CHECK(winnow_ok(Words{"sequence", all} + again + Words{"--threads", "1"}).code == 0);
  const std::string small_hash = hash_of_file(small);
  CHECK(winnow_ok(Words{"sequence", zstd_file(all)} + again + Words{"--threads", "3"}).code == 0);
  CHECK(hash_of_file(small) == small_hash);
}

TEST_CASE("a sequence stays within the budget that its message names", "[budget]") {
  const Directory directory;
  const Words names = write_frames(directory, {150}, frames);
  const Words arguments = call(directory, names) + Words{"--threads", "2"};
  const std::string memory = enough_memory(arguments);
  const Run run = run_winnow(arguments + Words{"--memory", memory});
  check_peak(run, memory);
}

TEST_CASE("frames that wait for one GLB stay within the budget", "[budget]") {
  const Directory directory;
  const Words names = write_frames(directory, {100}, frames);
  const Words arguments =
      Words{"sequence"} + names +
      Words{"-o", directory.file("all.glb"), "--json", "--force", "--ratio", "90%"};
  const std::string memory = enough_memory(arguments + Words{"--threads", "2"});
  const Run run = run_winnow(arguments + Words{"--threads", "2", "--memory", memory});
  check_peak(run, memory);
}

}  // namespace winnow::test
