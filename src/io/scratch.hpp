// Files without a name for what does not fit into memory.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace winnow {

// The scratch directory and what is written there. Files have no name in it: they vanish with the process,
// however that ends.
class Scratch {
 public:
  explicit Scratch(std::string directory);

  [[nodiscard]] const std::string& directory() const { return directory_; }
  [[nodiscard]] std::uint64_t written() const { return written_; }  // bytes, all files, ever
  [[nodiscard]] std::uint64_t peak() const { return peak_; }        // most bytes in use at one time

 private:
  friend class ScratchFile;
  void count(std::uint64_t bytes);
  void forget(std::uint64_t bytes) { in_use_ -= bytes; }

  std::string directory_;
  std::atomic<std::uint64_t> written_{0}, in_use_{0}, peak_{0};
};

// Removes the files in `directory` whose names begin so and which nobody holds a lock on: what a process that
// was killed left behind. Returns how many.
unsigned remove_stale_files(const std::string& directory, const std::string& name_prefix);

// How scratch files are called for the moment they have a name (on file systems without nameless files).
inline constexpr const char* scratch_prefix = "winnow-scratch-";

// What is written to one at a time.
inline constexpr std::size_t scratch_write_bytes = std::size_t{1} << 18;

// One such file: written by appending, read at any place. Appending is for one thread at a time.
class ScratchFile {
 public:
  explicit ScratchFile(Scratch& scratch);
  // One that has a name already, to be read alone: it keeps its name. Throws Error(bad_input) where it is not
  // there.
  ScratchFile(Scratch& scratch, const std::string& path);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  void append(std::span<const std::byte> bytes);                      // throws Error(resources)
  void read(std::uint64_t offset, std::span<std::byte> bytes) const;  // throws Error(resources)
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] std::string path() const;  // a name by which this process can open it again

  // Gives the file this name, by which it stays, and brings it to the disk. False where that is in another
  // file system, or this one has no nameless files.
  [[nodiscard]] bool keep_as(const std::string& name) const;

 private:
  Scratch& scratch_;
  int fd_ = -1;
  bool named_ = false;
  std::uint64_t size_ = 0;
};

}  // namespace winnow
