// The winnow program.
#include <winnow/error.hpp>
#include <winnow/mapped_guard.hpp>

#include "program.hpp"

#include <csignal>
#include <exception>
#include <iostream>
#include <new>

#include <fcntl.h>
#include <unistd.h>

namespace {

// A standard stream that is closed would be replaced by the next file that is opened, and messages would end
// up in the mesh. Opened for reading only, so that a mesh written to one of them is an error.
void open_standard_streams() {
  for (int fd = ::open("/dev/null", O_RDONLY); fd >= 0; fd = ::dup(fd)) {
    if (fd <= STDERR_FILENO) continue;
    ::close(fd);
    break;
  }
}

}  // namespace

int main(int argc, char** argv) {
  using winnow::ErrorKind;

  // Who closes it wants no report; but one that is wanted must not be lost.
  const bool heard = ::fcntl(STDOUT_FILENO, F_GETFD) >= 0;
  open_standard_streams();
  CLI::App app;
  winnow::cli::add_commands(app);

  // A reader that goes away, and a file-size limit, are write errors like any other.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const auto fail = [](const char* message, ErrorKind kind) {
    std::cerr << "winnow: " << message << "\n";
    return static_cast<int>(kind);
  };
  try {
    winnow::guard_mapped_files();
    winnow::cli::refuse_empty_values({argv, static_cast<std::size_t>(argc)});
    try {
      app.parse(argc, argv);
    } catch (const CLI::Success& asked_for_text) {
      app.exit(asked_for_text);
    }
    if (!std::cout.flush() && heard)
      return fail("cannot write to standard output; what it was to get is not whole", ErrorKind::resources);
    return 0;
  } catch (const CLI::ParseError& error) {
    return fail((std::string(error.what()) + "\nTry 'winnow --help' or 'winnow COMMAND --help'.").c_str(),
                ErrorKind::usage);
  } catch (const winnow::Error& error) {
    return fail(error.what(), error.kind());
  } catch (const std::bad_alloc&) {
    return fail("the system has no more memory; lower --memory or end other programs", ErrorKind::resources);
  } catch (const std::exception& error) {
    return fail(error.what(), ErrorKind::failed);
  }
}
