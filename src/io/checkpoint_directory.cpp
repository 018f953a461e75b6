#include "io/checkpoint_directory.hpp"

#include <winnow/error.hpp>

#include "base/checksum.hpp"
#include "io/file_descriptor.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow {

namespace {

constexpr const char* lock_name = "winnow-lock";
constexpr const char* new_manifest_name = "manifest.new";
constexpr const char* size_key = "file-size.";
constexpr const char* file_sum_key = "file-checksum.";

// Whatever else is in the directory is none of ours.
bool is_ours(const std::string& name) {
  return name == new_manifest_name || name.starts_with("stage-") || name.starts_with("round-");
}

[[noreturn]] void fail(const std::string& path, const std::string& doing, int code) {
  std::string text = "cannot " + doing + " '" + path + "': " + std::strerror(code);
  if (code == ENOSPC || code == EDQUOT || code == EFBIG) text += "; free some space";
  throw Error(ErrorKind::resources, text);
}

// A file that is on the disk when finish() returns.
class DurableFile {
 public:
  explicit DurableFile(std::string path)
      : path_(std::move(path)),
        fd_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600)) {
    if (fd_ < 0) fail(path_, "make", errno);
  }
  ~DurableFile() {
    if (fd_ >= 0) ::close(fd_);
  }
  DurableFile(const DurableFile&) = delete;
  DurableFile& operator=(const DurableFile&) = delete;

  void append(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t done = ::write(fd_, bytes.data(), bytes.size());
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) fail(path_, "write", done < 0 ? errno : ENOSPC);
      bytes = bytes.subspan(static_cast<std::size_t>(done));
    }
  }

  void finish() {
    if (::fsync(fd_) != 0) fail(path_, "write", errno);
    if (::close(std::exchange(fd_, -1)) != 0) fail(path_, "write", errno);
  }

 private:
  std::string path_;
  int fd_;
};

}  // namespace

CheckpointDirectory::CheckpointDirectory(Job& job, std::string path)
    : job_(job), path_(std::move(path)) {}

CheckpointDirectory::~CheckpointDirectory() {
  if (lock_ >= 0) ::close(lock_);
}

std::unique_ptr<CheckpointDirectory> CheckpointDirectory::begin(Job& job, const std::string& path) {
  std::error_code error;
  std::filesystem::create_directory(path, error);
  if (error || !std::filesystem::is_directory(path, error)) {
    throw Error(ErrorKind::usage, "`checkpoint`: '" + path +
                                      "' is no directory and cannot be made one" +
                                      (error ? ": " + error.message() : ""));
  }
  std::unique_ptr<CheckpointDirectory> directory(new CheckpointDirectory(job, path));
  directory->refuse_others();  // before there is a lock in it
  directory->lock();
  if (std::filesystem::exists(directory->manifest_path())) {
    throw Error(ErrorKind::usage,
                "'" + path + "' holds the checkpoint of another run; go on with it by winnow " +
                    "resume '" + path + "', remove it, or name another directory");
  }
  return directory;
}

void CheckpointDirectory::refuse_others() const {
  std::error_code error;
  if (std::filesystem::exists(manifest_path(), error)) return;
  for (const auto& entry : std::filesystem::directory_iterator(path_, error)) {
    const std::string name = entry.path().filename().string();
    // A run that was killed before it had begun can leave these.
    if (name == lock_name || name == new_manifest_name || name.starts_with(scratch_prefix))
      continue;
    throw Error(ErrorKind::usage, "`checkpoint`: '" + path_ +
                                      "' is not empty; name a directory that is, or a new one");
  }
}

std::unique_ptr<CheckpointDirectory> CheckpointDirectory::open(Job& job, const std::string& path) {
  std::unique_ptr<CheckpointDirectory> directory(new CheckpointDirectory(job, path));
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored))
    throw Error(ErrorKind::bad_input, "'" + path + "' is no directory with a checkpoint");
  // Nothing is left behind in a directory that is none of ours.
  const std::string name = directory->manifest_path();
  if (!std::filesystem::is_regular_file(directory->file(lock_name), ignored) &&
      !std::filesystem::is_regular_file(name, ignored)) {
    throw Error(
        ErrorKind::bad_input,
        "'" + path +
            "' holds no checkpoint: a run that has not begun leaves none, and one that is done " +
            "removes it; run the command again");
  }
  directory->lock();
  std::error_code missing;
  const auto kind = std::filesystem::status(name, missing).type();
  if (kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::regular)
    throw Error(ErrorKind::bad_input,
                "'" + name + "' is no file, so no checkpoint can be read from it");
  std::ifstream in(name, std::ios::binary);
  if (kind == std::filesystem::file_type::regular && !in)
    throw Error(cannot_open(errno), "cannot open '" + name + "': " + std::strerror(errno));
  if (!in) {
    ::unlink(directory->file(lock_name).c_str());
    throw Error(ErrorKind::bad_input, "'" + path + "' holds no checkpoint yet: '" + name +
                                          "' is missing; run the command again");
  }
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  directory->manifest_ = Manifest::parse(text, name);
  return directory;
}

void CheckpointDirectory::lock() {
  const std::string name = file(lock_name);
  for (;;) {
    lock_ = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (lock_ < 0) fail(name, "make", errno);
    if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
      if (errno != EWOULDBLOCK) fail(name, "lock", errno);
      throw Error(ErrorKind::resources, "another run works in '" + path_ +
                                            "'; wait for its end, or name another directory");
    }
    // A run that ended in between took the file away that was opened.
    struct stat mine {};
    struct stat there {};
    if (::fstat(lock_, &mine) == 0 && ::stat(name.c_str(), &there) == 0 &&
        mine.st_ino == there.st_ino)
      return;
    ::close(std::exchange(lock_, -1));
  }
}

void CheckpointDirectory::save(const std::string& name, const Spool& spool) {
  const std::string path = file(name);
  ::unlink(path.c_str());  // of a run that was killed before its commit()
  const bool kept = !spool.in_memory() && spool.file().keep_as(path);
  std::unique_ptr<DurableFile> copy = kept ? nullptr : std::make_unique<DurableFile>(path);
  Checksum sum;
  spool.for_each_part(1, [&](std::span<const std::byte> part) {
    job_.progress.check_cancelled();
    sum.add(part);
    if (copy != nullptr) copy->append(part);
  });
  if (copy != nullptr) copy->finish();
  manifest_.set(size_key + name, spool.size());
  manifest_.set(file_sum_key + name, sum.value());
}

void CheckpointDirectory::forget(const std::string& name) {
  manifest_.erase(size_key + name);
  manifest_.erase(file_sum_key + name);
}

bool CheckpointDirectory::has(const std::string& name) const {
  return manifest_.has(size_key + name);
}

Spool CheckpointDirectory::load(const std::string& name, std::uint64_t memory_limit) const {
  const std::string path = file(name);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) damaged_checkpoint(path, "it is missing");
  Spool spool(job_, memory_limit, std::make_unique<ScratchFile>(job_.scratch, path));
  if (spool.size() != manifest_.number(size_key + name))
    damaged_checkpoint(path, "its size does not fit");
  Checksum sum;
  spool.for_each_part(1, [&](std::span<const std::byte> part) {
    job_.progress.check_cancelled();
    sum.add(part);
  });
  if (sum.value() != manifest_.number(file_sum_key + name))
    damaged_checkpoint(path, "its checksum does not fit");
  return spool;
}

void CheckpointDirectory::sync() const {
  const int fd = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) fail(path_, "open", errno);
  const int failed = ::fsync(fd) != 0 ? errno : 0;
  ::close(fd);
  if (failed != 0) fail(path_, "write", failed);
}

template <typename Unwanted>
void CheckpointDirectory::remove_files(const Unwanted& unwanted) const {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(path_, ignored)) {
    const std::string name = entry.path().filename().string();
    if (is_ours(name) && unwanted(name)) ::unlink(entry.path().c_str());
  }
}

void CheckpointDirectory::commit() {
  const std::string text = manifest_.print();
  DurableFile fresh(file(new_manifest_name));
  fresh.append(std::as_bytes(std::span(text)));
  fresh.finish();
  sync();  // what the manifest names is there before it is
  if (::rename(file(new_manifest_name).c_str(), manifest_path().c_str()) != 0)
    fail(manifest_path(), "make", errno);
  sync();
  remove_files([this](const std::string& name) { return !has(name); });
}

void CheckpointDirectory::remove() {
  // The manifest last: it says that the run is done, should this one be killed here.
  remove_files([](const std::string&) { return true; });
  ::unlink(manifest_path().c_str());
  ::unlink(file(lock_name).c_str());
}

}  // namespace winnow
