// A run that is killed at any moment goes on and ends with the bytes of one that was not disturbed.
#include "support/random.hpp"
#include "support/simplified.hpp"

#include <chrono>
#include <csignal>
#include <thread>

namespace winnow::test {

namespace {

class Killed {
 public:
  Killed(const Directory& directory, const std::string& input, const Words& options,
         std::uint64_t seed)
      : directory_(directory), random_(seed), options_(options), input_(input) {
    const Run whole = winnow_ok(begin());
    seconds_ = whole.seconds;
    want_ = hash_of_file(output_);
    check_done();
  }

  // Runs to the end, killed on the way again and again. Returns how often.
  int run() {
    int kills = 0;
    for (Words arguments = begin();;) {
      Program program(arguments);
      std::this_thread::sleep_for(std::chrono::duration<double>(0.9 * seconds_ * random_.unit()));
      program.signal(SIGKILL);
      const Run run = program.wait();
      INFO(joined(arguments) << "\n" << run.err);
      if (exists(output_)) REQUIRE(hash_of_file(output_) == want_);  // whole, or not there
      if (run.signal == SIGKILL) {
        ++kills;
        arguments = resume();
        continue;
      }
      if (run.code == 3) {  // killed before the checkpoint was one
        REQUIRE(run.err.find("holds no checkpoint") != std::string::npos);
        // ... or after all was done, when it is none any more.
        if (exists(output_)) break;
        arguments = begin();
        continue;
      }
      REQUIRE(run.code == 0);
      break;
    }
    REQUIRE(hash_of_file(output_) == want_);
    check_done();
    return kills;
  }

 private:
  // Neither of them changes a byte.
  Words speed() {
    return {"-q", "--threads", std::to_string(random_.between(1, 3)), "--memory",
            random_.chance(0.5) ? "64M" : "512M"};
  }
  Words begin() {
    return Words{"simplify", input_, "-o", output_, "--checkpoint", kept_} + options_ + speed();
  }
  Words resume() { return Words{"resume", kept_} + speed(); }

  void check_done() {
    ::unlink(output_.c_str());
    std::error_code ignored;
    REQUIRE(std::filesystem::is_empty(kept_, ignored));
    REQUIRE(directory_.names() == Words{"in.ply", "kept"});
  }

  const Directory& directory_;
  Random random_;
  Words options_;
  std::string input_, output_ = directory_.file("out.ply"), kept_ = directory_.file("kept"), want_;
  double seconds_ = 0;
};

}  // namespace

TEST_CASE("a run that is killed at any moment goes on to the same bytes", "[faults][long]") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  generate("scan", 80'000, input);
  const int tries = sanitized ? 4 : 40;
  const struct {
    Words options;
    int kills;
  } cases[] = {{{"--faces", "3k"}, tries},
               {{"--faces", "3k", "--detail", "15"}, tries / 2},
               {{"--error", "0.05%"}, tries / 2},
               {{"--ratio", "5%", "--refine", "importance"}, tries / 4},
               {{"--cell", "0.01"}, tries / 4}};
  std::uint64_t seed = 1;
  for (const auto& [options, kills] : cases) {
    Killed killed(directory, input, options, seed++);
    for (int done = 0; done < kills;) done += killed.run();
  }
}

}  // namespace winnow::test
