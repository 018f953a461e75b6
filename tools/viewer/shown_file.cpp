#include "viewer/shown_file.hpp"

#include <winnow/error.hpp>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow::viewer {

ShownFile::ShownFile(const std::string& path, std::string shown)
    : shown_(std::move(shown)), fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (fd_ < 0)
    throw Error(ErrorKind::bad_input, "'" + path + "' cannot be read: " + std::strerror(errno));
  struct stat status {};
  if (::fstat(fd_, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(fd_);
    throw Error(ErrorKind::bad_input, "'" + path + "' is no regular file");
  }
  bytes_ = static_cast<std::uint64_t>(status.st_size);
}

ShownFile::~ShownFile() {
  if (fd_ >= 0) ::close(fd_);
}

ShownFile::ShownFile(ShownFile&& other) noexcept
    : shown_(std::move(other.shown_)), fd_(std::exchange(other.fd_, -1)), bytes_(other.bytes_) {}

std::size_t ShownFile::read(std::uint64_t at, std::span<char> into) const {
  std::size_t done = 0;
  while (done < into.size()) {
    const ssize_t got =
        ::pread(fd_, into.data() + done, into.size() - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace winnow::viewer
