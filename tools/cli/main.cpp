// The winnow program.
#include <winnow/error.hpp>
#include <winnow/mapped_guard.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_text.hpp"
#include "usage_errors.hpp"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace {

using winnow::ErrorKind;

// A standard stream that is closed would be replaced by the next file that is opened, and messages
// would end up in the mesh. Opened for reading only, so that a mesh written to one of them is an
// error.
void open_standard_streams() {
  for (int fd = ::open("/dev/null", O_RDONLY); fd >= 0; fd = ::dup(fd)) {
    if (fd <= STDERR_FILENO) continue;
    ::close(fd);
    break;
  }
}

// Whether who read standard output has seen enough of it, as `head` has.
bool reader_left() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

bool asks_for_help(const std::string& word) {
  return word == "help" || word == "--help" || word == "-h";
}

// The command line without the program's name; "help COMMAND" is "COMMAND --help", and so is
// "--help COMMAND".
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (!words.empty() && asks_for_help(words.front())) {
    words.erase(words.begin());
    words.resize(std::min<std::size_t>(words.size(), 1));
    if (!words.empty() && asks_for_help(words.front())) words.clear();
    words.emplace_back("--help");
  }
  return words;
}

// Runs what the command line asks for.
void run(CLI::App& app, std::vector<std::string> words) {
  winnow::guard_mapped_files();
  winnow::cli::refuse_empty_values(words);
  if (!words.empty()) winnow::cli::refuse_unknown_command(app, words.front());
  winnow::cli::name_simplified_frames(words);
  std::reverse(words.begin(), words.end());  // as parse() takes them
  try {
    app.parse(std::move(words));
  } catch (const CLI::Success& asked_for_text) {
    app.exit(asked_for_text);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // Who closes it wants no report; but one that is wanted must not be lost.
  const bool heard = ::fcntl(STDOUT_FILENO, F_GETFD) >= 0;
  open_standard_streams();
  const std::vector<std::string> words = words_of(argc, argv);
  CLI::App app;
  winnow::cli::add_commands(app, words.empty() ? "" : words.front());

  // A reader that goes away, and a file-size limit, are write errors like any other.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const bool json = std::find(words.begin(), words.end(), "--json") != words.end();
  const auto fail = [&](const std::string& message, ErrorKind kind, const char* help = "") {
    if (json) winnow::cli::print_failure(app, message, kind);
    winnow::cli::tell_error(message);
    std::cerr << help;
    std::cout.flush();
    return static_cast<int>(kind);
  };
  try {
    int code = 0;
    try {
      run(app, words);
    } catch (const winnow::cli::Ended& ended) {
      code = ended.code;
    }
    if (!std::cout.flush() && heard && !reader_left())
      return fail("cannot write to standard output; what it was to get is not whole",
                  ErrorKind::resources);
    return code;
  } catch (const CLI::ParseError& error) {
    return fail(winnow::cli::explain(app, error), ErrorKind::usage,
                "Try 'winnow --help' or 'winnow COMMAND --help'.\n");
  } catch (const winnow::Error& error) {
    return fail(error.what(), error.kind());
  } catch (const std::bad_alloc&) {
    return fail("the system has no more memory; lower --memory or end other programs",
                ErrorKind::resources);
  } catch (const std::exception& error) {
    // TBB and Embree tell so where a thread cannot be made.
    if (std::strstr(error.what(), "pthread_create") != nullptr) {
      return fail(
          "the system gives this run no more threads; try --threads 1, or end other programs",
          ErrorKind::resources);
    }
    return fail(error.what(), ErrorKind::failed);
  }
}
