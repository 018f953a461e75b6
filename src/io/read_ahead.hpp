// Asks the system for the part of a file that is going to be read: what a mapping is read ahead by
// itself is too little for a fast disk.
#pragma once

#include <atomic>
#include <cstdint>

namespace winnow {

// For one sweep through a file that other means read; from any thread. Costs nothing where the file
// is cached.
class ReadAhead {
 public:
  // Until `end`. Refusals by the system change nothing but speed.
  ReadAhead(int fd, std::uint64_t end) : fd_(fd), end_(end) {}

  // Bytes from `begin` to `end` are being read now.
  void reached(std::uint64_t begin, std::uint64_t end) {
    if (end + distance / 2 > asked_.load(std::memory_order_relaxed)) ask(begin, end);
  }

  void start_again() { asked_ = 0; }

 private:
  static constexpr std::uint64_t distance = std::uint64_t{16} << 20;
  void ask(std::uint64_t begin, std::uint64_t end);

  int fd_;
  std::uint64_t end_;
  std::atomic<std::uint64_t> asked_{0};
};

}  // namespace winnow
