// What every long call of the library runs in: how much it may use, how it tells of its progress,
// how it is stopped. Nothing in here changes a byte of any result.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

namespace winnow {

// One sign of life of a running call.
struct Progress {
  const char* stage = "";   // what it is doing: "sample", "cluster", "merge", "write", ...
  std::uint64_t done = 0;   // how much of it, in `unit`s
  std::uint64_t total = 0;  // of how much; 0 where that is not known (a pipe)
  const char* unit = "";    // "faces" or "bytes"
};

// The surroundings of a call. Fill it in, pass it by reference; it must outlive the call. One
// context may serve several calls, one after the other. Only cancel() may be called from other
// threads (and from a signal handler) while a call runs.
class Context {
 public:
  // Memory the call may use, in bytes: tables, buffers and mapped pages of the input all count. The
  // whole process stays below this + 32 MiB. What does not fit goes to scratch. Default: 512 MiB.
  std::uint64_t memory = std::uint64_t{512} << 20;

  // Threads that work at once; 0: as many as the machine has. They are oneTBB's. Where they are
  // more than the process has, it has more during the call; it never has fewer for other work.
  unsigned threads = 0;

  // Directory for scratch files; they have no name in it and vanish with the process. Empty: the
  // current directory. Should be on a disk: a directory held in memory defeats the budget.
  std::string scratch;

  // Map input files instead of reading them through a buffer: faster, but a file that another
  // program shortens meanwhile kills the process with SIGBUS, unless guard_mapped_files()
  // (mapped_guard.hpp) was called first. Default: read.
  bool map_input = false;

  // Called now and then (about ten times a second) from one of the working threads, never from two
  // at once. Empty: no progress. It must not throw.
  std::function<void(const Progress&)> progress;

  // Called with one line for the user about something worth knowing that is no error. Same rules.
  std::function<void(const std::string&)> notice;

  // Asks the running call to stop: it throws Error(cancelled) within a second and leaves nothing
  // behind. Safe in a signal handler.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const noexcept {
    return cancelled_.load(std::memory_order_relaxed);
  }
  // Takes that back, between calls: the context can be used again.
  void reset() noexcept { cancelled_.store(false, std::memory_order_relaxed); }

 private:
  std::atomic<bool> cancelled_{false};
  static_assert(std::atomic<bool>::is_always_lock_free);
};

}  // namespace winnow
