// Checkpoints of runs that were stopped at a known place.
#pragma once

#include <winnow/checkpoint.hpp>
#include <winnow/error.hpp>

#include "support/files.hpp"
#include "support/job.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

// Simplifies until `stage` begins for the `time`th time, and is stopped there. Two
// threads; the directory "kept" in `directory` is what is left.
inline Checkpoint stopped_at(const Directory& directory, const std::vector<std::string>& inputs,
                             const std::string& output, const SimplifyOptions& options,
                             const std::string& stage, int time = 1) {
  Context context;
  context.threads = 2;
  context.progress = [&](const Progress& progress) {
    // A sign of life in between comes sooner or later, or not at all.
    if (progress.done == 0 && progress.stage == stage && --time == 0) context.cancel();
  };
  const Checkpoint checkpoint{directory.file("kept")};
  const Error error = error_of([&] { simplify(context, inputs, output, options, checkpoint); });
  INFO(error.what());
  REQUIRE(error.kind() == ErrorKind::cancelled);
  REQUIRE(std::string(error.what()).find("go on by `resume` '" + checkpoint.directory + "'") !=
          std::string::npos);
  REQUIRE_FALSE(exists(output));
  return checkpoint;
}

inline SimplifyReport resumed(const Checkpoint& checkpoint, unsigned threads = 1) {
  Context context;
  context.threads = threads;
  return resume(context, checkpoint);
}

}  // namespace winnow::test
