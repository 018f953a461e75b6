// A call leaves the process that it runs in as it was.
#include <winnow/compare.hpp>
#include <winnow/mesh.hpp>

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/mesh_arrays.hpp"

#include <set>

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

namespace winnow::test {

namespace {

constexpr auto parallelism = tbb::global_control::max_allowed_parallelism;

SimplifyOptions to_few_faces() {
  SimplifyOptions options;
  options.target = Target::faces(500);
  return options;
}

}  // namespace

TEST_CASE("a call with one thread leaves the caller's other threads alone", "[library]") {
  const Mesh mesh = ball_arrays(60, false, false);
  Context context;
  context.threads = 1;
  const tbb::global_control host(parallelism, 3);
  std::set<std::size_t> seen;
  context.progress = [&](const Progress&) {
    seen.insert(tbb::global_control::active_value(parallelism));
  };
  simplify(context, mesh.view(), to_few_faces());
  CHECK(seen == std::set<std::size_t>{3});
}

TEST_CASE("nor does one that compares", "[library]") {
  const Directory directory;
  const std::string path = directory.file("ball.ply");
  write_file(path, ply_of_arrays(ball_arrays(60, false, false)));
  Context context;
  context.threads = 1;
  const tbb::global_control host(parallelism, 3);
  std::set<std::size_t> seen;
  context.progress = [&](const Progress&) {
    seen.insert(tbb::global_control::active_value(parallelism));
  };
  CompareOptions options;
  options.samples = 20'000;
  compare(context, path, path, options);
  CHECK(seen == std::set<std::size_t>{3});
}

TEST_CASE("a context that was cancelled can be used again once it is reset", "[library]") {
  const Directory directory;
  const Mesh mesh = ball_arrays(30, false, false);
  Context context;
  context.scratch = directory.path();
  const std::string right = ply_of_arrays(simplify(context, mesh.view(), to_few_faces()));
  context.progress = [&](const Progress&) { context.cancel(); };
  CHECK(error_of([&] { simplify(context, mesh.view(), to_few_faces()); }).kind() ==
        ErrorKind::cancelled);
  context.progress = nullptr;
  CHECK(context.cancelled());
  CHECK(error_of([&] { simplify(context, mesh.view(), to_few_faces()); }).kind() ==
        ErrorKind::cancelled);
  context.reset();
  CHECK((ply_of_arrays(simplify(context, mesh.view(), to_few_faces())) == right));
  CHECK(directory.names().empty());
}

}  // namespace winnow::test
