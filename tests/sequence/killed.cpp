// A sequence that is killed at any moment goes on to the same bytes, and within its budget.
#include "support/budget.hpp"
#include "support/moving_sheet.hpp"

#include <csignal>
#include <filesystem>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

std::string killing(int number, const std::string& part) {
  return "change " + std::to_string(number) + " 0 " + part;
}

// What is written to, but for the frames.
struct Place {
  Directory inputs, outputs;
  std::string kept = outputs.file("kept");

  [[nodiscard]] std::string hashes(std::size_t frames) const {
    std::string all;
    for (std::size_t t = 0; t < frames; ++t)
      all += hash_of_file(outputs.file("s-" + std::to_string(t) + ".ply"));
    return all;
  }
  void clear() const {
    for (const std::string& name : outputs.names()) std::filesystem::remove_all(outputs.file(name));
  }
};

}  // namespace

TEST_CASE("a sequence killed before any call that changes the disk goes on to the same bytes",
          "[faults][long]") {
  for (const Words& to :
       {Words{"-o", "s-{frame}.ply"}, Words{"-o", "s-{frame}.ply", "--per-frame", "30%"},
        Words{"-o", "s-0.ply", "--to", "glb"}}) {
    const Place place;
    const std::size_t frames = to.back() == "glb" ? 1 : 3;
    Words options = to;
    options[1] = place.outputs.file(to[1]);
    const Words arguments = Words{"sequence"} + write_frames(place.inputs, {8}, 3) + options +
                            Words{"--ratio", "30%", "--checkpoint", place.kept, "--threads", "2"};
    winnow_ok(arguments);
    const std::string want = place.hashes(frames);
    place.clear();
    int number = 1;
    for (;; ++number) {
      INFO(joined(to) << " " << number);
      Run run = run_winnow(arguments, {.fault = killing(number, place.outputs.path())});
      if (run.signal != SIGKILL) {
        CHECK(run.code == 0);
        break;
      }
      // Killed again, somewhere else.
      if (exists(place.kept + "/manifest"))
        run_winnow({"resume", place.kept},
                   {.fault = killing(1 + number * 7 % 11, place.outputs.path())});
      if (exists(place.kept + "/manifest")) {
        winnow_ok({"resume", place.kept});
      } else if (!exists(place.outputs.file("s-0.ply"))) {
        winnow_ok(arguments);
      }
      CHECK(place.hashes(frames) == want);
      for (const std::string& name : place.outputs.names())
        CHECK((name.starts_with("s-") || name == "kept"));
      place.clear();
    }
    CHECK(number > 40);  // that many such calls there are at least
  }
}

TEST_CASE("frames that were written before a sequence was killed are not written again",
          "[faults]") {
  const Place place;
  const std::size_t frames = 6;
  const Words arguments = Words{"sequence"} + write_frames(place.inputs, {12}, frames) +
                          Words{"-o", place.outputs.file("s-{frame}.ply"), "--ratio", "30%"};
  const Run whole = winnow_ok(arguments + Words{"--json"});
  const std::string want = place.hashes(frames);
  place.clear();
  // Where frame 4 gets its name.
  const Run killed =
      run_winnow(arguments + Words{"--checkpoint", place.kept}, {.fault = "rename 1 0 s-4.ply"});
  REQUIRE(killed.signal == SIGKILL);
  CHECK(exists(place.outputs.file("s-3.ply")));
  CHECK_FALSE(exists(place.outputs.file("s-4.ply")));
  // None of the first four is touched.
  const Run resumed = run_winnow({"resume", place.kept, "--json"}, {.fault = "rename 1 5 s-3.ply"});
  INFO(resumed.err);
  REQUIRE(resumed.code == 0);
  CHECK(place.hashes(frames) == want);
  for (const char* key : {"faces", "vertices", "bytes"})
    CHECK(resumed.json()["output"][key] == whole.json()["output"][key]);
  CHECK(resumed.json()["area"] == whole.json()["area"]);
}

TEST_CASE("a sequence with a checkpoint stays within its budget, resumed too", "[budget]") {
  const Place place;
  const Words arguments =
      Words{"sequence"} + write_frames(place.inputs, {150}, 40) +
      Words{"-o", place.outputs.file("s-{frame}.ply"), "--json", "--ratio", "10%", "--threads",
            "2"};
  const Run whole = winnow_ok(arguments);
  const std::string want = place.hashes(40);
  place.clear();
  const std::string memory = enough_memory(arguments + Words{"--force"});
  place.clear();
  INFO(memory);
  const Words speed{"--memory", memory};
  // Killed when the first round's mesh is brought to the disk.
  const Run killed = run_winnow(arguments + speed + Words{"--checkpoint", place.kept},
                                {.fault = "change 1 0 kept/stage-1"});
  REQUIRE(killed.signal == SIGKILL);
  CHECK(killed.peak_resident <= bytes_of_size(memory) + 32 * mebibyte);
  const Run resumed = run_winnow(Words{"resume", place.kept, "--threads", "2", "--json"} + speed);
  check_peak(resumed, memory);
  CHECK(resumed.json()["resumed"]["tiles"] > 1);
  CHECK(place.hashes(40) == want);
  place.clear();
  check_peak(run_winnow(arguments + speed + Words{"--checkpoint", place.kept}), memory);
  CHECK(place.hashes(40) == want);
}

}  // namespace winnow::test
