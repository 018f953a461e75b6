// What is measured of a sequence beside its original: distances by frame, and flicker by hand.
#include <winnow/compare_sequence.hpp>

#include "support/job.hpp"
#include "support/moving_sheet.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// The unit square in 2 n^2 faces, each frame as high as `height(frame)` says.
template <typename Height>
std::vector<std::string> write_squares(const Directory& directory, const std::string& name,
                                       std::size_t n, std::size_t frames, const Height& height) {
  const MovingSheet sheet{n};
  std::vector<std::string> names;
  for (std::size_t t = 0; t < frames; ++t) {
    std::vector<Point> positions = sheet.positions(0);
    for (Point& p : positions) p[2] = height(t);
    names.push_back(directory.file(name + std::to_string(t) + ".obj"));
    write_file(names.back(), obj_of(positions, sheet.faces()));
  }
  return names;
}

}  // namespace

TEST_CASE("flicker is the second difference over time, of the original at the same places") {
  const Directory directory;
  // 0.01 t^2 has the second difference 0.02 everywhere.
  const auto falling = [](std::size_t t) { return 0.01 * static_cast<double>(t * t); };
  const auto original = write_squares(directory, "o", 9, 6, falling);
  TestJob job;
  const SequenceComparison same =
      compare_sequence(job.context, original, write_squares(directory, "s", 4, 6, falling), 1000);
  REQUIRE(same.flicker);
  CHECK(same.flicker->original == Approx(0.02));
  CHECK(same.flicker->simplified == Approx(0.02));
  CHECK(same.worst_rms == Approx(0).margin(1e-9));
  CHECK(same.frames == 6);

  // Up and down by 0.001 adds 0.004 and takes it away in turn: the root mean square of 0.024 and
  // 0.016 twice each.
  const auto shaking = [&](std::size_t t) { return falling(t) + (t % 2 == 0 ? 0.001 : -0.001); };
  const SequenceComparison shaken =
      compare_sequence(job.context, original, write_squares(directory, "j", 4, 6, shaking), 1000);
  REQUIRE(shaken.flicker);
  CHECK(shaken.flicker->original == Approx(0.02));
  CHECK(shaken.flicker->simplified == Approx(std::sqrt((0.024 * 0.024 + 0.016 * 0.016) / 2)));
  CHECK(shaken.mean_rms == Approx(0.001));
  CHECK(shaken.rms.size() == 6);
}

TEST_CASE("the worst frame is told, and two frames have no flicker") {
  const Directory directory;
  const auto flat = [](std::size_t) { return 0.0; };
  const auto rising = [](std::size_t t) { return t == 1 ? 0.5 : 0.1; };
  TestJob job;
  const SequenceComparison found =
      compare_sequence(job.context, write_squares(directory, "o", 3, 2, flat),
                       write_squares(directory, "s", 3, 2, rising), 1000);
  CHECK(found.worst_frame == 1);
  CHECK(found.worst_rms == Approx(0.5));
  CHECK(found.mean_rms == Approx(0.3));
  CHECK_FALSE(found.flicker);
  CHECK(error_of([&] {
          (void)compare_sequence(job.context, {"a.ply", "b.ply"}, {"a.ply"}, 1000);
        }).kind() == ErrorKind::usage);
}

}  // namespace winnow
