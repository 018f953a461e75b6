#include "io/scratch.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow {

namespace {

[[noreturn]] void scratch_error(const std::string& directory, const std::string& doing, int code) {
  std::string text = "cannot " + doing + " scratch in '" + directory + "': " + std::strerror(code);
  if (code == ENOSPC || code == EDQUOT || code == EFBIG) {
    text += "; free some space, or name another directory with `scratch`";
  } else {
    text += "; name another directory with `scratch`";
  }
  throw Error(ErrorKind::resources, text);
}

int open_nameless(const std::string& directory) {
  int fd = ::open(directory.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (fd >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL)) return fd;
  // This file system knows no nameless files: take the name away at once. The lock tells
  // remove_stale_files() that somebody is between the two steps.
  std::string name = directory + "/" + scratch_prefix + "XXXXXX";
  fd = ::mkostemp(name.data(), O_CLOEXEC);
  if (fd >= 0) {
    ::flock(fd, LOCK_EX | LOCK_NB);
    ::unlink(name.c_str());
  }
  return fd;
}

}  // namespace

Scratch::Scratch(std::string directory)
    : directory_(directory.empty() ? "." : std::move(directory)) {}

Scratch::~Scratch() = default;

std::uint64_t Scratch::append_shared(std::span<const std::byte> bytes) {
  const std::scoped_lock lock(sharing_);
  if (shared_ == nullptr) shared_ = std::make_unique<ScratchFile>(*this, ScratchFile::Checked::no);
  const std::uint64_t place = shared_->size();
  shared_->append(bytes);
  return place;
}

void Scratch::read_shared(std::uint64_t offset, std::span<std::byte> bytes) {
  const std::scoped_lock lock(sharing_);
  shared_->read(offset, bytes);
}

void Scratch::damaged() const {
  throw Error(ErrorKind::resources,
              "scratch in '" + directory_ +
                  "' is damaged: a checksum does not fit. The disk may be failing; name "
                  "another directory with `scratch`");
}

void Scratch::count(std::uint64_t bytes) {
  written_ += bytes;
  const std::uint64_t now = in_use_ += bytes;
  std::uint64_t peak = peak_;
  while (now > peak && !peak_.compare_exchange_weak(peak, now)) {
  }
}

unsigned remove_stale_files(const std::string& directory, const std::string& name_prefix) {
  unsigned removed = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(directory, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(name_prefix) || !entry.is_regular_file(ignored)) continue;
    const int fd = ::open(entry.path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (fd < 0) continue;
    // An empty one may be of a run that is about to lock it: it makes another then.
    struct stat status {};
    if (::flock(fd, LOCK_EX | LOCK_NB) == 0 && ::fstat(fd, &status) == 0 &&
        ::unlink(entry.path().c_str()) == 0 && status.st_size > 0)
      ++removed;
    ::close(fd);
  }
  return removed;
}

ScratchFile::ScratchFile(Scratch& scratch, Checked checked)
    : scratch_(scratch), fd_(open_nameless(scratch.directory())) {
  if (checked == Checked::yes) sums_.emplace(scratch);
  if (fd_ < 0) scratch_error(scratch.directory(), "create", errno);
}

ScratchFile::ScratchFile(Scratch& scratch, const std::string& path)
    : scratch_(scratch), fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)), named_(true) {
  struct stat status {};
  if (fd_ < 0 || ::fstat(fd_, &status) != 0) {
    throw Error(ErrorKind::bad_input, "cannot open '" + path + "': " + std::strerror(errno));
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

ScratchFile::~ScratchFile() {
  if (!named_) scratch_.forget(size_);
  ::close(fd_);
}

void ScratchFile::append(std::span<const std::byte> bytes) {
  if (sums_) sums_->append(bytes);
  while (!bytes.empty()) {
    const ssize_t done = ::pwrite(fd_, bytes.data(), bytes.size(), static_cast<off_t>(size_));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) scratch_error(scratch_.directory(), "write", done < 0 ? errno : ENOSPC);
    size_ += static_cast<std::uint64_t>(done);
    scratch_.count(static_cast<std::uint64_t>(done));
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
}

void ScratchFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  if (!sums_) return read_unchecked(offset, bytes);
  if (offset + bytes.size() > size_) scratch_error(scratch_.directory(), "read", EIO);
  constexpr std::size_t block = BlockSums::block_bytes;
  while (!bytes.empty()) {
    const std::size_t inside = offset % block;
    const bool to_end = offset + bytes.size() == size_;
    const std::size_t whole = inside != 0 ? 0
                              : to_end    ? bytes.size()
                                          : bytes.size() / block * block;
    std::size_t done = whole;
    if (whole > 0) {
      read_unchecked(offset, bytes.first(whole));
      sums_->check(offset, bytes.first(whole));
    } else {
      // A part of a block alone.
      std::array<std::byte, block> around;
      const std::uint64_t begin = offset - inside;
      const auto all = std::span(around).first(std::min<std::uint64_t>(block, size_ - begin));
      read_unchecked(begin, all);
      sums_->check(begin, all);
      done = std::min(bytes.size(), all.size() - inside);
      std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(inside), done, bytes.begin());
    }
    offset += done;
    bytes = bytes.subspan(done);
  }
}

void ScratchFile::check(std::uint64_t offset, std::uint64_t bytes) const {
  std::array<std::byte, 16 * BlockSums::block_bytes> content;
  for (const std::uint64_t end = std::min(offset + bytes, size_); offset < end;) {
    const std::size_t length =
        std::min<std::uint64_t>(content.size() - offset % content.size(), end - offset);
    read(offset, std::span(content).first(length));
    offset += length;
  }
}

void ScratchFile::read_unchecked(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t done = ::pread(fd_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) scratch_error(scratch_.directory(), "read", errno);
    if (done == 0) scratch_error(scratch_.directory(), "read", EIO);
    offset += static_cast<std::uint64_t>(done);
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
}

std::string ScratchFile::path() const {
  return "/proc/self/fd/" + std::to_string(fd_);
}

bool ScratchFile::keep_as(const std::string& name) const {
  if (::linkat(AT_FDCWD, path().c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) != 0)
    return false;
  if (::fsync(fd_) != 0) scratch_error(scratch_.directory(), "write", errno);
  return true;
}

}  // namespace winnow
