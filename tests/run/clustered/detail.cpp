// Whether clustering comes before refinement, and how many faces it leaves.
#include "run/detail.hpp"

#include <limits>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("clustering comes first where it spares three quarters of the faces") {
  const std::uint64_t available = 4'000'000;
  SimplifyOptions options;
  const auto check = [&](std::uint64_t target, bool welded, std::uint64_t faces) {
    const Detail detail = detail_for(options, available, target);
    CAPTURE(target);
    CHECK(detail.welded == welded);
    CHECK(detail.faces == faces);
  };
  check(160'000, false, 960'000);
  options.boundary = Boundary::keep;
  check(160'000, false, 960'000);
  options.keep_pieces = true;
  check(160'000, true, available);
  options = {};
  check(170'000, true, available);
  check(5'000'000, true, available);
  // Who says how many means it.
  options.detail = 3;
  check(170'000, false, 510'000);
  check(1'200'000, false, 3'600'000);
  check(1'400'000, true, available);
  options.detail = std::numeric_limits<double>::infinity();
  check(4, true, available);
}

TEST_CASE("small inputs are refined from all of their faces") {
  const SimplifyOptions options;
  CHECK(detail_for(options, 1'000'000, 10).welded);
  CHECK_FALSE(detail_for(options, 1'100'000, 10).welded);
}

TEST_CASE("a ratio asks for the nearest count, and for no fewer than four") {
  SimplifyOptions options;
  CHECK(faces_wanted(options.target, 1000) == std::nullopt);
  options.target = Target::ratio(0.0123);
  CHECK(faces_wanted(options.target, 1000) == 12U);
  CHECK(faces_wanted(options.target, 100) == 4U);
  CHECK(faces_wanted(options.target, 10'000'000'000) == 123'000'000U);
  options.target = Target::faces(77);
  CHECK(faces_wanted(options.target, 10) == 77U);
}

}  // namespace winnow
