// Records appended to a named file by a run that may be killed at any moment, and read by the next.
#pragma once

#include "base/progress.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// A record counts if its checksum fits. The first that does not, because writing it was cut short
// or the disk lost it, ends what was written; what follows is written over it.
class Journal {
 public:
  explicit Journal(std::string path);  // made where it is missing
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // The next record of an earlier run; false where there are no more.
  bool next(std::vector<std::byte>& record);

  // After next() has given false. The parts become one record. A second of work at most is lost to
  // a power cut.
  void append(std::initializer_list<std::span<const std::byte>> parts);
  void sync();  // then nothing of it

 private:
  [[noreturn]] void fail(const char* doing, int code) const;

  std::string path_;
  int fd_;
  std::uint64_t at_ = 0;
  bool cut_ = false;
  Stopwatch since_sync_;
};

}  // namespace winnow
