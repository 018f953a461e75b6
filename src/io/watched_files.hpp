// Files that are closed before the run ends, but may not change until then.
#pragma once

#include <cstdint>
#include <map>
#include <string>

struct stat;

namespace winnow {

// What tells a file from another of the same name, or from itself after a change.
struct FileVersion {
  std::uint64_t device = 0, inode = 0, size = 0;
  std::int64_t seconds = 0, nanoseconds = 0;  // of its last change

  static FileVersion of(const struct stat& status);
  bool operator==(const FileVersion&) const = default;
};

// Throws Error(bad_input) if a file that had the version `before` has become shorter, or was
// changed and is as long as before. What is appended is not read.
void check_unchanged(const std::string& name, const FileVersion& before, const FileVersion& now);

// By their names, and by one thread at a time.
class WatchedFiles {
 public:
  // Throws Error(bad_input) if the file is watched already and had another version then.
  void add(const std::string& name, const FileVersion& version);

  // check_unchanged() of all that are still there.
  void check() const;

 private:
  std::map<std::string, FileVersion> versions_;
};

}  // namespace winnow
