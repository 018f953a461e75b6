// Preloaded into the program: makes one system call fail, or kills the program just before it.
// Which one says the environment:
//   WINNOW_FAULT=CALL NUMBER WHAT [PART]
// CALL is write (pwrite too), read (pread too), sync, close, rename, link or unlink, or `change`:
// all but read and close, what alters a disk. The NUMBER-th of those, from 1, on a file whose name
// has PART in it, fails with the error of number WHAT; where that is 0 the program gets SIGKILL.
// Where WHAT is -1 the call succeeds, but a pwrite brings one wrong bit to the disk.
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string>

#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>

namespace {

struct Fault {
  Fault() {
    const char* text = std::getenv("WINNOW_FAULT");
    if (text == nullptr) return;
    std::istringstream words(text);
    words >> call >> number >> error >> part;
  }
  std::string call, part;
  long number = 0;
  int error = 0;
  std::atomic<long> seen{0};
};

// Made when it is first asked for: that may be before this library's own objects are.
Fault& fault() {
  static Fault one;
  return one;
}

std::string name_of(int fd) {
  std::array<char, 4096> name{};
  const ssize_t length =
      ::readlink(("/proc/self/fd/" + std::to_string(fd)).c_str(), name.data(), name.size() - 1);
  return length < 0 ? "" : std::string(name.data(), static_cast<std::size_t>(length));
}

// Whether this call is the one that fails.
bool strikes(const std::string& call, bool changes, const std::string& name) {
  Fault& one = fault();
  if (one.number == 0 || (one.call != call && !(changes && one.call == "change"))) return false;
  if (name.find(one.part) == std::string::npos || ++one.seen != one.number) return false;
  if (one.error == 0) ::kill(::getpid(), SIGKILL);
  errno = one.error;
  return true;
}

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

ssize_t write(int fd, const void* bytes, size_t count) {
  static auto* const real = next<ssize_t(int, const void*, size_t)>("write");
  return fd > 2 && strikes("write", true, name_of(fd)) ? -1 : real(fd, bytes, count);
}

ssize_t pwrite(int fd, const void* bytes, size_t count, off_t at) {
  static auto* const real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  if (!strikes("write", true, name_of(fd))) return real(fd, bytes, count, at);
  if (fault().error != -1) return -1;
  std::string changed(static_cast<const char*>(bytes), count);
  changed[count / 2] = static_cast<char>(changed[count / 2] ^ 1 << fault().number % 8);
  return real(fd, changed.data(), count, at);
}

ssize_t read(int fd, void* bytes, size_t count) {
  static auto* const real = next<ssize_t(int, void*, size_t)>("read");
  return strikes("read", false, name_of(fd)) ? -1 : real(fd, bytes, count);
}

ssize_t pread(int fd, void* bytes, size_t count, off_t at) {
  static auto* const real = next<ssize_t(int, void*, size_t, off_t)>("pread");
  return strikes("read", false, name_of(fd)) ? -1 : real(fd, bytes, count, at);
}

int fsync(int fd) {
  static auto* const real = next<int(int)>("fsync");
  return strikes("sync", true, name_of(fd)) ? -1 : real(fd);
}

// As a disk that is found to be full when what was written is brought to it: the descriptor is gone
// all the same.
int close(int fd) {
  static auto* const real = next<int(int)>("close");
  const bool fails = strikes("close", false, name_of(fd));
  const int error = errno;
  const int result = real(fd);
  if (!fails) return result;
  errno = error;
  return -1;
}

int rename(const char* from, const char* to) noexcept {
  static auto* const real = next<int(const char*, const char*)>("rename");
  return strikes("rename", true, to) ? -1 : real(from, to);
}

int renameat2(int from_at, const char* from, int to_at, const char* to, unsigned flags) noexcept {
  static auto* const real = next<int(int, const char*, int, const char*, unsigned)>("renameat2");
  return strikes("rename", true, to) ? -1 : real(from_at, from, to_at, to, flags);
}

int linkat(int from_at, const char* from, int to_at, const char* to, int flags) noexcept {
  static auto* const real = next<int(int, const char*, int, const char*, int)>("linkat");
  return strikes("link", true, to) ? -1 : real(from_at, from, to_at, to, flags);
}

int unlink(const char* name) noexcept {
  static auto* const real = next<int(const char*)>("unlink");
  return strikes("unlink", true, name) ? -1 : real(name);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                   void* of) {
  static auto* const real =
      next<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create");
  return strikes("thread", false, "") ? errno : real(thread, attributes, work, of);
}

}  // extern "C"
