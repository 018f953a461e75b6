// How winnow reports that it could not go on.
#pragma once

#include <winnow/api.hpp>

#include <stdexcept>
#include <string>

namespace winnow {

// What went wrong, in the terms of the command line's exit codes.
enum class ErrorKind {
  failed = 1,      // anything that no other kind names
  usage = 2,       // options that contradict each other or make no sense
  bad_input = 3,   // the input is not what it should be; the message names the file and the place
  resources = 4,   // memory budget too small, disk full, write error, a reader that went away
  cancelled = 130  // Context::cancel was called
};

// Its name in reports.
constexpr const char* name_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return "usage";
    case ErrorKind::bad_input:
      return "bad_input";
    case ErrorKind::resources:
      return "resources";
    case ErrorKind::cancelled:
      return "cancelled";
    case ErrorKind::failed:
      break;
  }
  return "failed";
}

// Thrown by every function of the library that can fail. The message is one line, names the file
// and the place (byte, line or face) where there is one, and says the way out.
class WINNOW_API Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }

  // The exit code the winnow program ends with for this error: the kind's own number.
  [[nodiscard]] int exit_code() const noexcept { return static_cast<int>(kind_); }

 private:
  ErrorKind kind_;
};

}  // namespace winnow
