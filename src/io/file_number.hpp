// By what the system tells a file from all others, whatever names lead to it.
#pragma once

#include <sys/stat.h>

namespace winnow {

struct FileNumber {
  dev_t device = 0;
  ino_t number = 0;

  static FileNumber of(const struct stat& status) { return {status.st_dev, status.st_ino}; }
  bool operator==(const FileNumber&) const = default;
};

}  // namespace winnow
