#include "io/journal.hpp"

#include <winnow/error.hpp>

#include "base/checksum.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow {

namespace {

struct Head {
  std::uint64_t size, checksum;
};

constexpr double sync_seconds = 1;

}  // namespace

Journal::Journal(std::string path)
    : path_(std::move(path)),
      fd_(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600)) {
  if (fd_ < 0) fail("make", errno);
}

Journal::~Journal() {
  ::close(fd_);
}

void Journal::fail(const char* doing, int code) const {
  std::string text = std::string("cannot ") + doing + " '" + path_ + "': " + std::strerror(code);
  if (code == ENOSPC || code == EDQUOT || code == EFBIG) text += "; free some space";
  throw Error(ErrorKind::resources, text);
}

bool Journal::next(std::vector<std::byte>& record) {
  struct stat status {};
  if (::fstat(fd_, &status) != 0) fail("read", errno);
  const auto end = static_cast<std::uint64_t>(status.st_size);
  const auto read = [this](std::uint64_t at, void* into, std::size_t size) {
    return ::pread(fd_, into, size, static_cast<off_t>(at)) == static_cast<ssize_t>(size);
  };
  Head head{};
  if (end - at_ < sizeof head || !read(at_, &head, sizeof head)) return false;
  if (head.size > end - at_ - sizeof head) return false;
  record.resize(head.size);
  if (!read(at_ + sizeof head, record.data(), record.size()) ||
      Checksum::of(record) != head.checksum)
    return false;
  at_ += sizeof head + head.size;
  return true;
}

void Journal::append(std::initializer_list<std::span<const std::byte>> parts) {
  if (!std::exchange(cut_, true) && ::ftruncate(fd_, static_cast<off_t>(at_)) != 0)
    fail("write", errno);
  Checksum sum;
  Head head{};
  for (const std::span<const std::byte> part : parts) {
    sum.add(part);
    head.size += part.size();
  }
  head.checksum = sum.value();
  const auto write = [this](std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t done = ::pwrite(fd_, bytes.data(), bytes.size(), static_cast<off_t>(at_));
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) fail("write", done < 0 ? errno : ENOSPC);
      at_ += static_cast<std::uint64_t>(done);
      bytes = bytes.subspan(static_cast<std::size_t>(done));
    }
  };
  write(std::as_bytes(std::span(&head, 1)));
  for (const std::span<const std::byte> part : parts) write(part);
  if (since_sync_.seconds() >= sync_seconds) sync();
}

void Journal::sync() {
  if (::fdatasync(fd_) != 0) fail("write", errno);
  since_sync_ = {};
}

}  // namespace winnow
