// Files without a name for what does not fit into memory.
#pragma once

#include "io/block_sums.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

namespace winnow {

class ScratchFile;

// The scratch directory and what is written there. Files have no name in it: they vanish with the
// process, however that ends.
class Scratch {
 public:
  explicit Scratch(std::string directory);
  ~Scratch();

  [[nodiscard]] const std::string& directory() const { return directory_; }
  [[nodiscard]] std::uint64_t written() const { return written_; }  // bytes, all files, ever
  [[nodiscard]] std::uint64_t peak() const { return peak_; }        // most bytes in use at one time

  // A file that all share: returns where the bytes are in it. By any thread; both throw
  // Error(resources).
  std::uint64_t append_shared(std::span<const std::byte> bytes);
  void read_shared(std::uint64_t offset, std::span<std::byte> bytes);

  // Throws Error(resources): what was read is not what was written.
  [[noreturn]] void damaged() const;

 private:
  friend class ScratchFile;
  void count(std::uint64_t bytes);
  void forget(std::uint64_t bytes) { in_use_ -= bytes; }

  std::string directory_;
  std::atomic<std::uint64_t> written_{0}, in_use_{0}, peak_{0};
  std::mutex sharing_;
  std::unique_ptr<ScratchFile> shared_;
};

// Removes the files in `directory` whose names begin so and which nobody holds a lock on: what a
// process that was killed left behind. Returns how many of them were not empty.
unsigned remove_stale_files(const std::string& directory, const std::string& name_prefix);

// How scratch files are called for the moment they have a name (on file systems without nameless
// files).
inline constexpr const char* scratch_prefix = "winnow-scratch-";

// What is written to one at a time.
inline constexpr std::size_t scratch_write_bytes = std::size_t{1} << 18;

// One such file: written by appending, read at any place. Appending is for one thread at a time.
class ScratchFile {
 public:
  // Unchecked: for content that tells itself whether it is damaged.
  enum class Checked : bool { no, yes };
  explicit ScratchFile(Scratch& scratch, Checked checked = Checked::yes);
  // One that has a name already, to be read alone: it keeps its name. Throws Error(bad_input) where
  // it is not there. Not checked.
  ScratchFile(Scratch& scratch, const std::string& path);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  void append(std::span<const std::byte> bytes);  // throws Error(resources)
  void read(std::uint64_t offset,
            std::span<std::byte> bytes) const;  // throws Error(resources), if damaged, too
  void check(std::uint64_t offset, std::uint64_t bytes) const;  // reads for those errors alone
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[noreturn]] void damaged() const { scratch_.damaged(); }
  // A name by which this process can open it again. Whoever maps it calls check() for what is
  // looked at.
  [[nodiscard]] std::string path() const;

  // Gives the file this name, by which it stays, and brings it to the disk. False where that is in
  // another file system, or this one has no nameless files.
  [[nodiscard]] bool keep_as(const std::string& name) const;

 private:
  void read_unchecked(std::uint64_t offset, std::span<std::byte> bytes) const;

  Scratch& scratch_;
  std::optional<BlockSums> sums_;
  int fd_ = -1;
  bool named_ = false;
  std::uint64_t size_ = 0;
};

}  // namespace winnow
