// A run in its checkpoint: what is kept of it when, and where it goes on.
#pragma once

#include <winnow/checkpoint.hpp>
#include <winnow/error.hpp>

#include "io/byte_sink.hpp"
#include "io/checkpoint_directory.hpp"
#include "run/clustering.hpp"
#include "run/outputs.hpp"
#include "run/run_request.hpp"

#include <memory>
#include <string>
#include <vector>

namespace winnow {

class RunCheckpoint {
 public:
  RunCheckpoint() = default;  // keeps nothing
  static RunCheckpoint begin(Job& job, const Checkpoint& settings, const RunRequest& request);
  static RunCheckpoint open(Job& job, const Checkpoint& settings);

  // Of a checkpoint that was opened. Throws Error(usage) where it is one of another call.
  [[nodiscard]] RunRequest request(ResumableCall call) const;
  // Throws Error(bad_input) where an input is not what it was.
  void check_inputs() const;

  // The input could be opened: from now on the run can be resumed.
  void begun();
  [[nodiscard]] bool opened() const { return opened_; }
  // Where an output is there that the run has not written. One that is resumed cannot be told to
  // replace it.
  [[nodiscard]] const char* way_out() const {
    return opened_ ? "move it away and resume again" : ByteSink::by_force;
  }
  // Whether the input was read, and its mesh is here.
  [[nodiscard]] bool has_mesh() const;
  Clustered load(Job& job, std::uint64_t memory) const;
  void save(Job& job, Clustered& clustered);

  // Whether the outputs are whole and under their names. Then the report is kept, too.
  [[nodiscard]] bool are_written(const std::vector<std::string>& outputs) const;
  // Whether this one of them is.
  [[nodiscard]] bool is_written(std::size_t number, const std::string& output) const;
  template <typename Report>
  void load_report(Report& report) const {
    get_report(directory_->manifest(), report);
  }
  // Before the outputs get their names.
  void settled(const Outputs& outputs, const SimplifyReport& report);
  // The same of other outputs than meshes and maps; `identities`: see ByteSink.
  template <typename Report>
  void settled(const std::vector<std::string>& identities, const Report& report) {
    if (directory_ == nullptr) return;
    put_report(directory_->manifest(), report);
    settle(identities);
  }
  // Whether this file is the map of this number that the run wrote before it was killed.
  [[nodiscard]] bool holds_map(std::size_t number, const std::string& path) const;
  // When they have them: removes the files, unless they are to be kept.
  void finish(Job& job);

  // Null where nothing is kept.
  [[nodiscard]] CheckpointDirectory* directory() const { return directory_.get(); }

  // An error came: adds to the message how to go on, where the run can; removes the files
  // otherwise.
  [[noreturn]] void fail(const Error& error);

 private:
  void settle(const std::vector<std::string>& identities);

  std::unique_ptr<CheckpointDirectory> directory_;
  bool keep_ = false;
  bool opened_ = false, begun_ = false;
};

}  // namespace winnow
