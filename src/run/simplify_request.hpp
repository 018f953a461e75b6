// What simplify() was asked for, in the manifest of a checkpoint and back.
#pragma once

#include <winnow/simplify.hpp>

#include "io/manifest.hpp"

#include <string>

namespace winnow {

struct SimplifyRequest {
  std::string input, output;
  SimplifyOptions options;
};

// Names of files are made absolute: the run may go on elsewhere.
void put(Manifest& manifest, const SimplifyRequest& request);
SimplifyRequest request_in(const Manifest& manifest);

// Size, time and both ends of the input's content.
void put_input(Manifest& manifest, const std::string& input);
// Throws Error(bad_input) where the input is not what it was. `read`: all of it was read; then it may be
// gone.
void check_input(const Manifest& manifest, const std::string& input, bool read, const std::string& directory);

// What a run has reported so far, but for its time, memory and scratch.
void put_report(Manifest& manifest, const SimplifyReport& report);
void get_report(const Manifest& manifest, SimplifyReport& report);

}  // namespace winnow
