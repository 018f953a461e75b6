// Options of refinement that make no sense, or none together, are usage errors before anything is
// read.
#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "support/job.hpp"
#include "support/not_finite.hpp"

#include <functional>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

void check_usage(const std::string& word, const std::function<void(SimplifyOptions&)>& change) {
  SimplifyOptions options;
  change(options);
  Context context;
  for (const bool plan : {false, true}) {
    const Error error = error_of([&] {
      if (plan) {
        plan_simplify(context, "none.ply", "small.ply", options);
      } else {
        simplify(context, "none.ply", "small.ply", options);
      }
    });
    CAPTURE(error.what());
    CHECK(error.kind() == ErrorKind::usage);
    CHECK(std::string(error.what()).find(word) != std::string::npos);
  }
}

}  // namespace

TEST_CASE("options of refinement that cannot be are refused by name") {
  for (const Refine cost : {Refine::none, Refine::volume, Refine::importance}) {
    check_usage("`error`",
                [&](SimplifyOptions& o) { o.target = Target::error(1), o.refine = cost; });
  }
  for (const double error : {0.0, -1.0, nan, infinity})
    check_usage("`error`", [&](SimplifyOptions& o) { o.target = Target::error(error); });
  check_usage("`cell`",
              [](SimplifyOptions& o) { o.target = Target::cell(1), o.refine = Refine::quadric; });
  check_usage("`grid`",
              [](SimplifyOptions& o) { o.target = Target::grid(10), o.refine = Refine::quadric; });
  for (const double detail : {1.0, 0.5, 0.0, -3.0, nan})
    check_usage("`detail`",
                [&](SimplifyOptions& o) { o.target = Target::faces(100), o.detail = detail; });
  check_usage("`detail`", [](SimplifyOptions& o) {
    o.target = Target::faces(100), o.refine = Refine::none, o.detail = 3;
  });
  check_usage("`detail`", [](SimplifyOptions& o) { o.target = Target::cell(1), o.detail = 3; });
  for (const double angle : {0.0, -10.0, 90.5, nan, infinity})
    check_usage("`max_normal_deviation`", [&](SimplifyOptions& o) {
      o.target = Target::faces(100), o.max_normal_deviation = angle;
    });
  check_usage("`max_normal_deviation`",
              [](SimplifyOptions& o) { o.target = Target::cell(1), o.max_normal_deviation = 20; });
  check_usage("`max_normal_deviation`", [](SimplifyOptions& o) {
    o.target = Target::faces(100), o.refine = Refine::none, o.max_normal_deviation = 20;
  });
  check_usage("exactly one of `faces`", [](SimplifyOptions& o) { o.target = {}; });
}

}  // namespace winnow::test
