// The frames of a sequence that were written to files of their own, kept in a checkpoint: a run
// that goes on writes the others.
#pragma once

#include <winnow/sequence.hpp>

#include "io/checkpoint_directory.hpp"
#include "io/journal.hpp"
#include "io/manifest.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace winnow {

class WrittenFrames {
 public:
  // Null: nothing is kept.
  explicit WrittenFrames(const CheckpointDirectory* checkpoint);

  // Whether an earlier run wrote this file for that frame.
  [[nodiscard]] bool has(std::size_t frame, const std::string& name) const;
  // How many of the first files are there.
  [[nodiscard]] std::size_t count(const std::vector<std::string>& names) const;
  // What names a file that is there (ByteSink), and what was told with it.
  [[nodiscard]] std::string identity(std::size_t frame) const;
  void load_report(std::size_t frame, SequenceReport& report) const;

  // A file before it has its name; `report`: of all frames so far.
  void add(std::size_t frame, const std::string& identity, const SequenceReport& report);

 private:
  std::string path_;
  std::unique_ptr<Journal> journal_;
  std::map<std::size_t, Manifest> frames_;  // of the earlier run
};

}  // namespace winnow
