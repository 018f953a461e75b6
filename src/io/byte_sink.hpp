// Bytes out: a file that appears whole or not at all, or a pipe.
#pragma once

#include "io/compressing.hpp"
#include "io/job.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

namespace winnow {

// Written from front to back by one thread at a time. Unless finish() was called nothing stays
// under the output's name. Throws Error(resources) where writing fails or the reader of a pipe went
// away.
class ByteSink {
 public:
  // A file's name, or "-" for standard output. A regular file is written aside, in the same
  // directory, and renamed by finish(); what an earlier run that was killed left aside is removed.
  // Anything else is written straight. An existing regular file is an Error(usage) unless `force`;
  // at once, not at the end; `way_out` ends its message. From then on open_source() refuses to read
  // that file. Where the name ends in .gz or .zst, what is written is compressed.
  ByteSink(Job& job, std::string path, bool force, const char* way_out = by_force);
  static constexpr const char* by_force = "use `force` to replace it";
  ~ByteSink();
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;

  // Of what is no text: Error(usage) where it would go to a terminal.
  void refuse_terminal() const;

  void write(std::span<const std::byte> bytes);
  // Everything that can fail for want of room; of several files, all are settled before any is
  // finished.
  void flush_and_sync();
  // Gives the file its name.
  void finish() { finish(false); }
  // The same; what it replaces stays aside for as long as the sink lives.
  void finish_for_now() { finish(true); }
  // After that: gives back all but what take_back() needs. The file has no identity() any more.
  void release() noexcept;
  // After finish_for_now(): what had the name before has it again, where the file system can
  // exchange names.
  void take_back() noexcept;

  // Names the file that flush_and_sync() brought to the disk, also when it is under its own name;
  // empty where it is written straight.
  [[nodiscard]] std::string identity() const;
  // Whether the file of this name is that one.
  static bool is(const std::string& path, const std::string& identity);

  [[nodiscard]] std::uint64_t written() const { return written_; }  // before compression

 private:
  void finish(bool for_now);
  [[noreturn]] void refuse_existing() const;
  void open_aside(mode_t rights);  // of a new file
  void open_straight(bool named_pipe);
  void pass_on(std::span<const std::byte> bytes);
  void put(std::span<const std::byte> bytes);
  [[noreturn]] void fail(int code) const;

  Job& job_;
  std::string path_;    // "" for standard output
  std::string aside_;   // the name it is written under meanwhile; "" where it is written straight
  bool named_ = false;  // the file has its name,
  bool replaced_ = false;  // and what had it before is aside
  bool force_;
  const char* way_out_;
  bool pipe_ = false;  // may block for as long as its reader likes
  int fd_ = -1;
  std::unique_ptr<Compressor> compressor_;
  std::vector<std::byte> packed_;
  std::uint64_t written_ = 0;
  std::uint64_t placed_ = 0;  // bytes in the file
  std::uint64_t behind_ = 0;  // bytes that the system was already asked to bring to the disk
  std::vector<std::byte> buffer_;
};

}  // namespace winnow
