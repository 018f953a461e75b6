#include "io/byte_sink.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow {

namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 18;

std::string directory_of(const std::string& path) {
  const auto parent = std::filesystem::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

// What a link points to is written, not the link replaced; also where that does not exist yet.
std::string behind_links(const std::string& path) {
  constexpr int most_links = 40;  // as many as the system follows
  std::filesystem::path target(path);
  std::error_code error;
  for (int i = 0; i < most_links && std::filesystem::is_symlink(target, error); ++i) {
    const std::filesystem::path next = std::filesystem::read_symlink(target, error);
    if (error) return path;
    target = target.parent_path() / next;  // an absolute `next` stands alone
  }
  return target.string();
}

// Of a file's name what the name of the file beside it begins with. That is not longer than a long
// name, so that whatever the file system allows for the one it allows for the other.
std::string kept_part(const std::string& name) {
  constexpr std::size_t short_name = 40;
  constexpr std::size_t added = sizeof("..winnow-") + std::numeric_limits<unsigned>::digits10 + 1;
  if (name.size() <= short_name) return name;
  std::size_t kept = name.size() - added;
  while (kept > 0 && (static_cast<unsigned char>(name[kept]) & 0xC0) == 0x80)
    --kept;  // whole UTF-8
  return name.substr(0, kept);
}

// No other file has the same number while this one is there, and hardly one later the same time
// besides.
std::string identity_of(const struct stat& status) {
  return std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino) + ":" +
         std::to_string(status.st_size) + ":" + std::to_string(status.st_mtim.tv_sec) + "." +
         std::to_string(status.st_mtim.tv_nsec);
}

}  // namespace

std::string ByteSink::identity() const {
  struct stat status {};
  return aside_.empty() || ::fstat(fd_, &status) != 0 ? "" : identity_of(status);
}

bool ByteSink::is(const std::string& path, const std::string& identity) {
  struct stat status {};
  return !identity.empty() && ::stat(path.c_str(), &status) == 0 && identity_of(status) == identity;
}

void ByteSink::refuse_existing() const {
  throw Error(ErrorKind::usage, "'" + path_ + "' exists; " + way_out_);
}

ByteSink::ByteSink(Job& job, std::string path, bool force, const char* way_out)
    : job_(job), path_(std::move(path)), force_(force), way_out_(way_out) {
  buffer_.reserve(buffer_bytes);
  if (path_.empty()) throw Error(ErrorKind::usage, "the output's name is empty");
  compressor_ = make_compressor(job_, path_);
  struct stat status {};
  // A link that leads to no file, as /dev/fd/63 to a pipe, may lead nowhere by its name.
  const bool there = ::stat(path_.c_str(), &status) == 0;
  // Else it would be found out when all is done.
  if (!there && errno == ENAMETOOLONG) fail(errno);
  const bool no_file = there && !S_ISREG(status.st_mode);
  if (path_ != "-" && (!no_file || S_ISDIR(status.st_mode))) path_ = behind_links(path_);
  if (path_ == "-") {
    path_.clear();
    fd_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    if (fd_ < 0) fail(errno);
  } else if (no_file) {
    if (S_ISDIR(status.st_mode))
      throw Error(ErrorKind::usage, "'" + path_ + "' is a directory; name a file in it");
    open_straight(S_ISFIFO(status.st_mode));
  } else {
    if (status.st_nlink != 0 && !force_) refuse_existing();
    if (there) job_.written_over.push_back(FileNumber::of(status));
    // A mesh gets the rights of any new file, or those that the replaced file had, but never rights
    // of its owner for whoever runs it.
    const bool replaces = status.st_nlink != 0;
    open_aside(replaces ? 0600 : 0666);
    if (replaces) ::fchmod(fd_, status.st_mode & 0777);
  }
  if (::fstat(fd_, &status) == 0) pipe_ = S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode);
  if (aside_.empty() && S_ISREG(status.st_mode))
    job_.written_over.push_back(FileNumber::of(status));
}

void ByteSink::refuse_terminal() const {
  if (::isatty(fd_) != 1) return;
  throw Error(ErrorKind::usage,
              "a terminal cannot show what is no text; name a file, send standard output to a file "
              "or a pipe, "
              "or write text with `to` obj");
}

void ByteSink::release() noexcept {
  if (fd_ >= 0) ::close(std::exchange(fd_, -1));
  buffer_ = {};
}

void ByteSink::take_back() noexcept {
  if (!std::exchange(named_, false)) return;
  if (replaced_) {
    ::renameat2(AT_FDCWD, aside_.c_str(), AT_FDCWD, path_.c_str(), RENAME_EXCHANGE);
  } else {
    ::unlink(path_.c_str());
  }
}

ByteSink::~ByteSink() {
  if (fd_ >= 0) ::close(fd_);
  if (!aside_.empty()) ::unlink(aside_.c_str());
}

void ByteSink::open_aside(mode_t rights) {
  const std::string prefix =
      "." + kept_part(std::filesystem::path(path_).filename().string()) + ".winnow-";
  if (remove_stale_files(directory_of(path_), prefix) > 0) {
    job_.note("an earlier run was killed while it wrote '" + path_ +
              "'; what it had written was removed");
  }
  // Nobody else's, not even later: below it may be removed by its name.
  std::random_device random;
  for (;;) {
    aside_ = directory_of(path_) + "/" + prefix + std::to_string(random());
    fd_ = ::open(aside_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, rights);
    if (fd_ < 0 && errno == EEXIST) continue;
    if (fd_ < 0) {
      const int code = errno;
      aside_.clear();
      fail(code);
    }
    // Before it is locked another run may take it for one of a run that was killed.
    const bool locked = ::flock(fd_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    struct stat status {};
    if (locked && ::fstat(fd_, &status) == 0 && status.st_nlink > 0) return;
    ::unlink(aside_.c_str());
    ::close(std::exchange(fd_, -1));
  }
}

void ByteSink::open_straight(bool named_pipe) {
  for (;;) {
    // A named pipe without a reader would make open() wait where cancelling is not noticed.
    fd_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | (named_pipe ? O_NONBLOCK : 0));
    if (fd_ >= 0 || !named_pipe || errno != ENXIO) break;
    job_.progress.check_cancelled();
    ::usleep(50'000);
  }
  if (fd_ < 0) fail(errno);
  if (named_pipe) ::fcntl(fd_, F_SETFL, ::fcntl(fd_, F_GETFL) & ~O_NONBLOCK);
}

void ByteSink::fail(int code) const {
  const std::string name = path_.empty() ? "standard output" : "'" + path_ + "'";
  if (code == EPIPE) throw Error(ErrorKind::resources, "the reader of " + name + " went away");
  std::string text = "cannot write " + name + ": " + std::strerror(code);
  if (code == ENOSPC || code == EDQUOT || code == EFBIG)
    text += "; free some space or write elsewhere";
  throw Error(ErrorKind::resources, text);
}

void ByteSink::write(std::span<const std::byte> bytes) {
  written_ += bytes.size();
  if (buffer_.size() + bytes.size() > buffer_bytes) {
    pass_on(buffer_);
    buffer_.clear();
  }
  if (bytes.size() >= buffer_bytes) {
    pass_on(bytes);
  } else {
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  }
}

void ByteSink::pass_on(std::span<const std::byte> bytes) {
  if (compressor_ == nullptr) return put(bytes);
  // In parts, so that what is packed stays small, and cancelling is noticed.
  while (!bytes.empty()) {
    const std::size_t length = std::min(bytes.size(), buffer_bytes);
    job_.progress.check_cancelled();
    compressor_->add(bytes.first(length), packed_);
    put(packed_);
    packed_.clear();
    bytes = bytes.subspan(length);
  }
}

void ByteSink::put(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    std::size_t length = bytes.size();
    if (pipe_) {
      // A pipe that poll() calls writable takes this much without blocking, so cancelling is
      // noticed.
      length = std::min<std::size_t>(length, 4096);
      pollfd ready{fd_, POLLOUT, 0};
      const int got = ::poll(&ready, 1, 100);
      job_.progress.check_cancelled();
      if (got == 0 || (got < 0 && errno == EINTR)) continue;
    }
    const ssize_t done = ::write(fd_, bytes.data(), length);
    if (done < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (done < 0) fail(errno);
    bytes = bytes.subspan(static_cast<std::size_t>(done));
    placed_ += static_cast<std::uint64_t>(done);
  }
  // Dirty pages go to the disk while the rest is still made, so that the fsync at the end has
  // little to do.
  if (!aside_.empty() && placed_ - behind_ > (std::uint64_t{8} << 20)) {
    ::sync_file_range(fd_, static_cast<off_t>(behind_), 0, SYNC_FILE_RANGE_WRITE);
    behind_ = placed_;
  }
}

void ByteSink::flush_and_sync() {
  pass_on(buffer_);
  buffer_.clear();
  if (compressor_ != nullptr) {
    compressor_->finish(packed_);
    compressor_.reset();
    put(packed_);
    packed_ = {};
  }
  job_.progress.check_cancelled();
  if (!aside_.empty() && ::fsync(fd_) != 0) fail(errno);
}

void ByteSink::finish(bool for_now) {
  flush_and_sync();
  if (aside_.empty()) {
    const int fd = std::exchange(fd_, -1);
    if (::close(fd) != 0 && errno != EINTR) fail(errno);
    return;
  }
  // With the last descriptor goes the lock that keeps other runs from taking the file away: not
  // before it has its name.
  const int written = std::exchange(fd_, ::fcntl(fd_, F_DUPFD_CLOEXEC, 3));
  if (::close(written) != 0) fail(errno);
  const auto rename_with = [&](unsigned flag) {
    return ::renameat2(AT_FDCWD, aside_.c_str(), AT_FDCWD, path_.c_str(), flag) == 0;
  };
  if (!rename_with(RENAME_NOREPLACE)) {
    if (errno == EEXIST && !force_) refuse_existing();
    // Not every file system knows the flags; then what has the name is replaced for good.
    if (errno != EEXIST && errno != EINVAL) fail(errno);
    replaced_ = for_now && rename_with(RENAME_EXCHANGE);
    if (!replaced_ && !rename_with(0)) fail(errno);
  }
  named_ = true;
  const int directory = ::open(directory_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (directory >= 0) {
    ::fsync(directory);  // the name, too, survives a power cut
    ::close(directory);
  }
}

}  // namespace winnow
