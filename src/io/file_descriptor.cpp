#include "io/file_descriptor.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow {

DescriptorStream::DescriptorStream(Job& job, int fd, std::string name)
    : job_(job), fd_(fd), name_(std::move(name)) {
  struct stat status {};
  if (::fstat(fd_, &status) != 0) return;
  number_ = FileNumber::of(status);
  directory_ = S_ISDIR(status.st_mode);
  if (S_ISREG(status.st_mode) && ::lseek(fd_, 0, SEEK_CUR) == 0) {
    size_ = static_cast<std::uint64_t>(status.st_size);
    version_ = FileVersion::of(status);
    ::posix_fadvise(fd_, 0, 0, POSIX_FADV_SEQUENTIAL);
  }
#ifdef F_SETPIPE_SZ
  // Fewer, larger exchanges with the program at the other end; a refusal costs nothing but speed.
  if (S_ISFIFO(status.st_mode)) ::fcntl(fd_, F_SETPIPE_SZ, 1 << 20);
#endif
}

DescriptorStream::~DescriptorStream() {
  ::close(fd_);
}

std::size_t DescriptorStream::read(std::span<std::byte> into) {
  for (;;) {
    if (!size_) {
      pollfd ready{fd_, POLLIN, 0};
      const int got = ::poll(&ready, 1, 100);
      job_.progress.check_cancelled();
      if (got == 0 || (got < 0 && errno == EINTR)) continue;
    }
    const ssize_t got = size_
                            ? ::pread(fd_, into.data(), into.size(), static_cast<off_t>(position_))
                            : ::read(fd_, into.data(), into.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      throw Error(ErrorKind::bad_input, "cannot read '" + name_ + "' at byte " +
                                            grouped(position_) + ": " + std::strerror(errno));
    }
    if (got == 0 && size_ && position_ < *size_) {
      shortened(name_, position_);
    }
    position_ += static_cast<std::uint64_t>(got);
    return static_cast<std::size_t>(got);
  }
}

void DescriptorStream::check_whole() const {
  struct stat status {};
  if (version_ && ::fstat(fd_, &status) == 0)
    check_unchanged(name_, *version_, FileVersion::of(status));
}

ErrorKind cannot_open(int code) {
  return code == EMFILE || code == ENFILE || code == ENOMEM ? ErrorKind::resources
                                                            : ErrorKind::bad_input;
}

void shortened(const std::string& name, std::uint64_t offset) {
  throw Error(ErrorKind::bad_input,
              "'" + name + "' was shortened by another program while it was read, near byte " +
                  grouped(offset) + "; run again when it is whole");
}

void changed(const std::string& name) {
  throw Error(ErrorKind::bad_input,
              "'" + name +
                  "' was changed by another program while it was read; run again "
                  "when nothing writes to it");
}

void DescriptorStream::seek(std::uint64_t position) {
  position_ = position;
}

std::size_t PrefixedStream::read(std::span<std::byte> into) {
  if (given_ == prefix_.size()) return rest_->read(into);
  const std::size_t length = std::min(into.size(), prefix_.size() - given_);
  std::memcpy(into.data(), prefix_.data() + given_, length);
  given_ += length;
  return length;
}

}  // namespace winnow
