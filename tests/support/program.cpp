#include "support/program.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifndef WINNOW_PROGRAM
#define WINNOW_PROGRAM ""
#define WINNOW_FAULTS ""
#endif

namespace winnow::test {

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

[[noreturn]] void fail(const std::string& doing) {
  throw std::runtime_error(doing + ": " + std::strerror(errno));
}

int nameless_file() {
  const int fd = ::open("/tmp", O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (fd < 0) fail("a file for the child's output");
  return fd;
}

std::string content(int fd) {
  std::string text(static_cast<std::size_t>(::lseek(fd, 0, SEEK_END)), '\0');
  std::size_t filled = 0;
  while (filled < text.size()) {
    const ssize_t got =
        ::pread(fd, text.data() + filled, text.size() - filled, static_cast<off_t>(filled));
    if (got <= 0) break;
    filled += static_cast<std::size_t>(got);
  }
  return text;
}

struct Pipe {
  int read = -1, write = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("a pipe");
  return {ends[0], ends[1]};
}

// Descriptors that the child gets for one of its streams, and ours.
struct Stream {
  int child = -1, ours = -1, kept = -1;
};

Stream open_in(const std::string& name) {
  if (name == "|") {
    const Pipe pipe = make_pipe();
    return {pipe.read, pipe.write, -1};
  }
  const int fd = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) fail(name);
  return {fd, -1, -1};
}

Stream open_out(const std::string& name) {
  if (name.empty()) {
    const int fd = nameless_file();
    return {fd, -1, fd};
  }
  if (name == "|") {
    const Pipe pipe = make_pipe();
    return {pipe.write, pipe.read, -1};
  }
  const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (fd < 0) fail(name);
  return {fd, -1, -1};
}

void close_fd(int& fd) {
  if (fd >= 0) ::close(fd);
  fd = -1;
}

std::string read_some(int fd, std::size_t most) {
  if (fd < 0) return {};
  std::string bytes(most, '\0');
  ssize_t got = 0;
  do {
    got = ::read(fd, bytes.data(), bytes.size());
  } while (got < 0 && errno == EINTR);
  bytes.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
  return bytes;
}

// In the child, between fork and exec.
[[noreturn]] void become(const Setup& setup, const std::array<int, 3>& streams,
                         std::vector<char*>& arguments) {
  for (int target = 0; target < 3; ++target)
    ::dup2(streams[static_cast<std::size_t>(target)], target);
  for (const int fd : setup.closed) ::close(fd);
  if (!setup.directory.empty() && ::chdir(setup.directory.c_str()) != 0) ::_exit(99);
  if (setup.largest_file != 0) {
    const rlimit limit{setup.largest_file, setup.largest_file};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  if (setup.unprivileged && ::geteuid() == 0) {
    constexpr uid_t nobody = 65534;
    if (::setgroups(0, nullptr) != 0 || ::setgid(nobody) != 0 || ::setuid(nobody) != 0) ::_exit(98);
  }
  // What Catch or a shell changed must not reach the program.
  for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ, SIGBUS}) ::signal(number, SIG_DFL);
  if (!setup.fault.empty()) {
    ::setenv("WINNOW_FAULT", setup.fault.c_str(), 1);
    ::setenv("LD_PRELOAD", WINNOW_FAULTS, 1);
    ::setenv("ASAN_OPTIONS", "verify_asan_link_order=0", 1);
  }
  ::execv(arguments[0], arguments.data());
  ::_exit(97);
}

}  // namespace

nlohmann::json Run::json() const {
  const std::string& text = out.find('{') != std::string::npos ? out : err;
  const std::size_t begin = text.find("{\n");
  if (begin == std::string::npos) throw std::runtime_error("no report in: " + out + err);
  return nlohmann::json::parse(text.substr(begin));
}

Program::Program(const std::vector<std::string>& arguments, const Setup& setup) {
  ::signal(SIGPIPE, SIG_IGN);  // for write()
  Stream in = open_in(setup.in);
  Stream out = open_out(setup.out);
  Stream err = open_out(setup.err);
  in_ = in.ours;
  out_ = out.ours;
  err_ = err.ours;
  kept_out_ = out.kept;
  kept_err_ = err.kept;

  std::vector<std::string> words{WINNOW_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  since_ = now();
  pid_ = ::fork();
  if (pid_ < 0) fail("fork");
  if (pid_ == 0) become(setup, {in.child, out.child, err.child}, pointers);
  ::close(in.child);
  if (out.kept < 0) ::close(out.child);
  if (err.kept < 0) ::close(err.child);
}

Program::~Program() {
  if (!ended_) {
    ::kill(pid_, SIGKILL);
    ::kill(pid_, SIGCONT);
    reap(true);
  }
  for (int* fd : {&in_, &out_, &err_, &kept_out_, &kept_err_}) close_fd(*fd);
}

bool Program::write(const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t done = ::write(in_, bytes.data() + at, bytes.size() - at);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return false;
    at += static_cast<std::size_t>(done);
  }
  return true;
}

void Program::close_in() {
  close_fd(in_);
}
void Program::close_out() {
  close_fd(out_);
}
std::string Program::read(std::size_t most) {
  return read_some(out_, most);
}
std::string Program::read_err() {
  return read_some(err_, 1 << 16);
}

void Program::await_handlers() {
  const double until = now() + 10 * patience;
  const std::string process = "/proc/" + std::to_string(pid_);
  std::error_code ignored;
  for (; now() < until && running(); std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
    // Between fork and exec the handlers are those of the tests.
    if (!std::filesystem::equivalent(process + "/exe", WINNOW_PROGRAM, ignored)) continue;
    std::ifstream status(process + "/status");
    std::uint64_t caught = 0;
    for (std::string word; status >> word;) {
      if (word == "SigCgt:") status >> std::hex >> caught;
    }
    const auto catches = [&](int number) { return (caught >> (number - 1) & 1) != 0; };
    if (catches(SIGINT) && catches(SIGTERM)) return;
  }
}

void Program::signal(int number) {
  if (ended_) return;
  since_ = now();
  ::kill(pid_, number);
}

bool Program::reap(bool block) {
  if (ended_) return true;
  int status = 0;
  rusage usage{};
  pid_t got = 0;
  do {
    got = ::wait4(pid_, &status, block ? 0 : WNOHANG, &usage);
  } while (got < 0 && errno == EINTR);
  if (got != pid_) return false;
  run_.seconds = now() - since_;
  run_.peak_resident = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  if (WIFEXITED(status)) run_.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) run_.signal = WTERMSIG(status);
  ended_ = true;
  return true;
}

bool Program::running() {
  return !reap(false);
}

Run Program::wait(double seconds) {
  close_in();
  const double until = now() + seconds * patience;
  while (!reap(false)) {
    if (now() > until) {
      ::kill(pid_, SIGKILL);
      ::kill(pid_, SIGCONT);
      reap(true);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  close_out();
  if (kept_out_ >= 0) run_.out = content(kept_out_);
  if (kept_err_ >= 0) run_.err = content(kept_err_);
  return run_;
}

Run run_winnow(const std::vector<std::string>& arguments, const Setup& setup) {
  return Program(arguments, setup).wait();
}

Run winnow_ok(const std::vector<std::string>& arguments, const Setup& setup) {
  Run run = run_winnow(arguments, setup);
  std::string line;
  for (const std::string& word : arguments) line += " " + word;
  INFO("winnow" << line << "\n" << run.err);
  REQUIRE(run.signal == 0);
  REQUIRE(run.code == 0);
  return run;
}

void generate(const std::string& surface, std::uint64_t faces, const std::string& path,
              GenerateOptions options) {
  options.surface = surface == "scan"   ? Surface::scan
                    : surface == "part" ? Surface::part
                                        : Surface::terrain;
  options.faces = faces;
  Context context;
  winnow::generate(context, path, options);
}

}  // namespace winnow::test
