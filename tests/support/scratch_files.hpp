// Scratch files of this process, to be damaged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow::test {

inline std::set<int> descriptors() {
  std::set<int> open;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    open.insert(std::stoi(entry.path().filename()));
  }
  std::erase_if(open,
                [](int fd) { return ::fcntl(fd, F_GETFD) == -1; });  // that of the list itself
  return open;
}

// Those that are open now and were not before, from the lowest on.
inline std::vector<int> opened_since(const std::set<int>& before) {
  std::vector<int> opened;
  for (const int fd : descriptors()) {
    if (before.count(fd) == 0) opened.push_back(fd);
  }
  return opened;
}

// A scratch file has no name; this is one by its descriptor.
class OpenedFile {
 public:
  explicit OpenedFile(int fd) : fd_(fd) {}

  [[nodiscard]] std::uint64_t size() const {
    struct stat status {};
    ::fstat(fd_, &status);
    return static_cast<std::uint64_t>(status.st_size);
  }

  void flip(std::uint64_t byte, unsigned bit) const {
    unsigned char value = 0;
    REQUIRE(::pread(fd_, &value, 1, static_cast<off_t>(byte)) == 1);
    value = static_cast<unsigned char>(value ^ 1U << bit);
    REQUIRE(::pwrite(fd_, &value, 1, static_cast<off_t>(byte)) == 1);
  }

  void clear(std::uint64_t byte, std::size_t count) const {
    const std::string zeros(count, '\0');
    REQUIRE(::pwrite(fd_, zeros.data(), count, static_cast<off_t>(byte)) ==
            static_cast<ssize_t>(count));
  }

  void cut(std::uint64_t size) const { REQUIRE(::ftruncate(fd_, static_cast<off_t>(size)) == 0); }

 private:
  int fd_;
};

}  // namespace winnow::test
