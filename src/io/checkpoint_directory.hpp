// A directory in which a run keeps what it needs to go on after it was killed.
#pragma once

#include "io/job.hpp"
#include "io/manifest.hpp"
#include "io/spool.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace winnow {

// Locked for as long as the object lives. Only what the manifest names counts, and journals, which
// know what counts in them; docs/design/checkpoints.md tells of the files.
class CheckpointDirectory {
 public:
  // For a new run: makes the directory where it is missing; it must be empty otherwise. Throws
  // Error(usage).
  static std::unique_ptr<CheckpointDirectory> begin(Job& job, const std::string& path);
  // Of a run that ended. Throws Error(bad_input) where there is no checkpoint, or a damaged one;
  // Error(resources) where its run is still alive.
  static std::unique_ptr<CheckpointDirectory> open(Job& job, const std::string& path);

  ~CheckpointDirectory();
  CheckpointDirectory(const CheckpointDirectory&) = delete;
  CheckpointDirectory& operator=(const CheckpointDirectory&) = delete;

  Manifest& manifest() { return manifest_; }
  [[nodiscard]] const Manifest& manifest() const { return manifest_; }
  [[nodiscard]] std::string manifest_path() const { return file("manifest"); }
  [[nodiscard]] const std::string& path() const { return path_; }
  // What a file is called outside.
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

  // Brings the content to the disk under this name. It counts from the next commit() on.
  void save(const std::string& name, const Spool& spool);
  void forget(const std::string& name);  // the same
  [[nodiscard]] bool has(const std::string& name) const;
  // What was saved. Throws Error(bad_input) where the file is not what it was.
  [[nodiscard]] Spool load(const std::string& name, std::uint64_t memory_limit) const;

  // From now on a run that goes on starts from the manifest as it is. Files of ours that it does
  // not name are removed.
  void commit();

  // Removes the files of a run that is done, or that would have to begin anew.
  void remove();

 private:
  CheckpointDirectory(Job& job, std::string path);
  void refuse_others() const;  // files that no run of ours left
  void lock();
  void sync() const;
  template <typename Unwanted>
  void remove_files(const Unwanted& unwanted) const;

  Job& job_;
  std::string path_;
  int lock_ = -1;
  Manifest manifest_;
};

}  // namespace winnow
