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

TEST_CASE("a picture shows up to eight frames above, and below what is left of them") {
  const Directory directory;
  const auto falling = [](std::size_t t) { return -0.1 * static_cast<double>(t); };
  const auto flat = [](std::size_t) { return 0.0; };
  const auto original = write_squares(directory, "o", 20, 11, falling);
  const auto simplified = write_squares(directory, "s", 2, 11, falling);
  CompareOptions options;
  options.samples = 1000;
  options.picture = directory.file("sheet.png");
  options.force = true;
  const auto picture_of = [&](const std::vector<std::string>& below, unsigned threads) {
    TestJob job;
    job.context.threads = threads;
    (void)compare_sequence(job.context, original, below, options);
    return bytes_of_file(options.picture);
  };
  const std::string picture = picture_of(simplified, 1);
  REQUIRE(picture.starts_with("\x89PNG"));
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(picture[at]); };
  const unsigned width = byte(18) * 256U + byte(19);
  CHECK(width % 8 == 0);
  CHECK(width >= 800);
  CHECK(picture_of(simplified, 3) == picture);
  CHECK(picture_of(write_squares(directory, "f", 2, 11, flat), 1) != picture);
}

TEST_CASE("a picture of frames is named as one, and replaces none unasked") {
  const Directory directory;
  const auto still = [](std::size_t) { return 0.0; };
  const std::vector<std::string> frames = write_squares(directory, "o", 2, 2, still);
  CompareOptions options;
  const auto kind_of = [&] {
    TestJob job;
    return error_of([&] { (void)compare_sequence(job.context, frames, frames, options); }).kind();
  };
  options.picture = directory.file("sheet.jpg");
  CHECK(kind_of() == ErrorKind::usage);
  options.picture = directory.file("sheet.png");
  write_file(options.picture, "mine");
  CHECK(kind_of() == ErrorKind::usage);
  CHECK(bytes_of_file(options.picture) == "mine");
}

}  // namespace winnow
