// Which file is which frame, and how the results are called.
#include "sequence/frame_names.hpp"

#include "support/job.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using Names = std::vector<std::string>;

TEST_CASE("frames are in the order of their numbers") {
  const FrameNames frames = frame_names({"run/f10.ply", "run/f9.ply", "run/f100.ply"});
  CHECK(frames.inputs == Names{"run/f9.ply", "run/f10.ply", "run/f100.ply"});
  CHECK(frames.labels == Names{"9", "10", "100"});
  const FrameNames padded = frame_names({"4d/a-0002.obj.zst", "4d/a-0001.obj.zst"});
  CHECK(padded.inputs == Names{"4d/a-0001.obj.zst", "4d/a-0002.obj.zst"});
  CHECK(padded.labels == Names{"0001", "0002"});
}

TEST_CASE("other names are frames in the order given") {
  const FrameNames frames = frame_names({"rest.ply", "bent.ply"});
  CHECK(frames.inputs == Names{"rest.ply", "bent.ply"});
  CHECK(frames.labels == Names{"1", "2"});
  // The same number twice is no order, nor are numbers of folders.
  CHECK(frame_names({"a1.ply", "a01.ply"}).labels == Names{"1", "2"});
  CHECK(frame_names({"2/a.ply", "1/a.ply"}).inputs == Names{"2/a.ply", "1/a.ply"});
  CHECK(frame_names(Names(12, "a.ply")).labels.front() == "01");
}

TEST_CASE("results are named by {frame}") {
  CHECK(names_of_frames("s-{frame}.ply", {"07", "08"}) == Names{"s-07.ply", "s-08.ply"});
  CHECK(names_of_frames("{frame}/{frame}.ply", {"1"}) == Names{"1/1.ply"});
  const Error error = test::error_of([] { (void)names_of_frames("small.ply", {"1", "2"}); });
  CHECK(error.kind() == ErrorKind::usage);
  CHECK(std::string(error.what()).find("{frame}") != std::string::npos);
}

}  // namespace winnow
