// A polygon of very many corners: its memory is reserved before it is there, and whoever wants to
// stop is heard while it is read and cut.
#include <winnow/error.hpp>
#include <winnow/info.hpp>

#include "support/budget.hpp"
#include "support/files.hpp"
#include "support/random.hpp"

#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>
#include <thread>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// Around a middle, at random distances from it, so that it has to be cut by a sweep.
std::string star_file(std::uint32_t corners) {
  Random random(77);
  const std::string count = std::to_string(corners);
  std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex " + count +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                     "property list uint uint vertex_indices\nend_header\n";
  const auto put = [&](const auto& value) {
    file.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double radius = 0.5 + random.unit();
    for (const double x : {radius * std::cos(angle), radius * std::sin(angle), 0.0})
      put(static_cast<float>(x));
  }
  put(corners);
  for (std::uint32_t i = 0; i < corners; ++i) put(i);
  return file;
}

double cpu_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

TEST_CASE("a large polygon is refused before it is there, with a budget that is enough",
          "[budget]") {
  const Directory directory;
  const std::string ply = directory.file("star.ply");
  write_file(ply, star_file(500'000));
  const Run fine = winnow_ok({"info", ply, "--json"});
  CHECK(fine.json()["faces"] == 499'998);
  for (const std::string& input : {ply, zstd_file(ply)}) {
    const Words command{"info", input, "--json", "--threads", "2"};
    const Run refused = run_winnow(command + Words{"--memory", "64M"});
    INFO(input << ": " << refused.err);
    REQUIRE(refused.code == 4);
    CHECK(refused.peak_resident <= 96 * mebibyte);
    const std::string memory = enough_memory(command);
    check_peak(run_winnow(command + Words{"--memory", memory}), memory);
  }
}

TEST_CASE("whoever wants to stop is heard while a large polygon is read and cut", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("star.ply");
  write_file(input, star_file(1'000'000));
  Context whole;
  whole.memory = 2048 * mebibyte;
  const double begin = cpu_seconds();
  info(whole, input);
  const double all = cpu_seconds() - begin;
  for (int part = 1; part < 10; ++part) {
    CAPTURE(part, all);
    Context context;
    context.memory = whole.memory;
    double asked = 0;
    std::thread stopper([&] {
      std::this_thread::sleep_for(std::chrono::duration<double>(part * all / 10));
      asked = cpu_seconds();
      context.cancel();
    });
    bool cancelled = false;
    try {
      info(context, input);
    } catch (const Error& error) {
      cancelled = error.kind() == ErrorKind::cancelled;
    }
    const double ended = cpu_seconds();
    stopper.join();
    // Of time on the processor, which a busy machine does not lengthen.
    if (cancelled) CHECK(ended - asked < 1);
    CHECK((cancelled || part > 3));
  }
}

}  // namespace winnow::test
