// A mesh in memory takes hardly more time than its file without reading and writing. A measurement,
// so it is run by hand on a quiet machine: run_tests "[.timed]"
#include <winnow/mesh.hpp>

#include "support/files.hpp"
#include "support/mesh_arrays.hpp"

#include <algorithm>
#include <ctime>
#include <limits>
#include <string_view>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// Of all threads of the process.
double processor_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

// What a call took, and of that what it took to read and to write.
struct Times {
  double all = 0, reading_and_writing = 0;

  template <typename Call>
  static Times of(Context& context, const Call& call) {
    Times times;
    bool counted = true;  // opening the input is reading, too
    double before = processor_seconds();
    const double begin = before;
    const auto end_stage = [&] {
      const double now = processor_seconds();
      if (counted) times.reading_and_writing += now - before;
      before = now;
    };
    context.progress = [&](const Progress& progress) {
      if (progress.done > 0) return;
      end_stage();
      const std::string_view stage = progress.stage;
      counted = stage.starts_with("read ") || stage == "write";
    };
    call();
    end_stage();
    times.all = before - begin;
    context.progress = nullptr;
    return times;
  }
};

}  // namespace

TEST_CASE("memory to memory takes as long as the file without reading and writing", "[.timed]") {
  constexpr double most = 1.05;
  const Directory directory;
  Context context;
  context.scratch = directory.path();
  const std::string input = directory.file("in.ply");
  const std::string output = directory.file("out.ply");
  const Mesh mesh = ball_arrays(200, false, false);
  write_file(input, ply_of_arrays(mesh));
  SimplifyOptions options;
  options.force = true;
  for (const Target target : {Target::faces(mesh.face_count() / 10), Target::cell(0.01)}) {
    options.target = target;
    // The best of each, in turn, as other programs run at the same time.
    double memory = std::numeric_limits<double>::max();
    double file = memory;
    for (int turn = 0; turn < 30 && (turn < 3 || memory > most * file); ++turn) {
      memory = std::min(memory,
                        Times::of(context, [&] { simplify(context, mesh.view(), options); }).all);
      const Times times = Times::of(context, [&] { simplify(context, input, output, options); });
      file = std::min(file, times.all - times.reading_and_writing);
    }
    CHECK(memory <= most * file);
  }
}

}  // namespace winnow::test
