// What goes first into every long call inside the library: the caller's context with the budget,
// the scratch directory and the progress meter of this one run.
#pragma once

#include <winnow/context.hpp>

#include "base/budget.hpp"
#include "base/process.hpp"
#include "base/progress.hpp"
#include "io/file_number.hpp"
#include "io/scratch.hpp"
#include "io/watched_files.hpp"

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

namespace winnow {

struct Job {
  // `scratch_directory`: where the context names none.
  explicit Job(Context& c, const std::string& scratch_directory = {})
      : context(c),
        threads(c.threads == 0 ? processors() : c.threads),
        budget(c.memory),
        scratch(c.scratch.empty() ? scratch_directory : c.scratch),
        progress(c) {}

  // Remembers one line about the run for its report, and tells it at once where somebody listens.
  void note(const std::string& line) {
    const std::scoped_lock lock(noting);
    if (std::find(notes.begin(), notes.end(), line) != notes.end()) return;  // of an earlier pass
    notes.push_back(line);
    if (context.notice) context.notice(line);
  }

  Context& context;
  unsigned threads;
  Budget budget;
  Scratch scratch;
  ProgressMeter progress;
  std::vector<FileNumber> written_over;  // files that the outputs take the place of, or are
  WatchedFiles watched;                  // beside the inputs
  std::vector<std::string> notes;
  std::mutex noting;
};

}  // namespace winnow
