// The built program as a child process: what it reads and writes, how it ends, what it uses.
#pragma once

#include "generate/generate.hpp"
#include "support/sanitized.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <sys/types.h>

namespace winnow::test {

// How a child is started.
struct Setup {
  std::string in = "/dev/null";  // standard input: a file, or "|": a pipe, see Program::write()
  std::string
      out{};  // standard output: a file, "|": a pipe, see Program::read(); empty: kept in Run::out
  std::string err{};        // standard error: a file, or "|": a pipe; empty: kept in Run::err
  std::string directory{};  // where it runs; empty: here
  std::uint64_t largest_file = 0;  // RLIMIT_FSIZE, in bytes; 0: none
  std::vector<int> closed{};       // descriptors that it finds closed
  std::string fault{};             // a system call that fails: see preload/faults.cpp; empty: none
  bool unprivileged = false;       // give up root's right to read and write everything
};

// How a child ended.
struct Run {
  int code = -1;   // exit code; -1 where a signal killed it
  int signal = 0;  // that signal
  std::string out, err;
  double seconds = 0;               // from its start, or from stop() or kill(), whichever was last
  std::uint64_t peak_resident = 0;  // bytes, by wait4: all pages, mapped ones too

  // The report of --json, from whichever stream carries it.
  [[nodiscard]] nlohmann::json json() const;
};

class Program {
 public:
  // `arguments` without the program's own name.
  explicit Program(const std::vector<std::string>& arguments, const Setup& setup = {});
  ~Program();  // kills it if it still runs
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  // To its standard input. False when the child does not read any more.
  bool write(const std::string& bytes);
  void close_in();

  // From its standard output or standard error: what is there, waiting for it; empty at the end.
  std::string read(std::size_t most = 1 << 16);
  std::string read_err();
  void close_out();

  // Until it has set its handlers: before, a signal ends it as it ends any program.
  void await_handlers();
  void signal(int number);  // Run::seconds counts from here
  [[nodiscard]] bool running();
  [[nodiscard]] pid_t pid() const { return pid_; }

  // Waits for its end; closes the pipes to it first. After `seconds` it is killed by SIGKILL.
  Run wait(double seconds = 120);

 private:
  bool reap(bool block);

  pid_t pid_ = -1;
  int in_ = -1, out_ = -1, err_ = -1;  // our ends of pipes
  int kept_out_ = -1, kept_err_ = -1;  // nameless files
  double since_ = 0;
  bool ended_ = false;
  Run run_;
};

// Starts, waits.
Run run_winnow(const std::vector<std::string>& arguments, const Setup& setup = {});

// The same, checked: it ended with 0.
Run winnow_ok(const std::vector<std::string>& arguments, const Setup& setup = {});

// A surface of `winnow generate`, by name, written to `path`.
void generate(const std::string& surface, std::uint64_t faces, const std::string& path,
              GenerateOptions options = {});

}  // namespace winnow::test
