// What a call that can be resumed was asked for, in the manifest of a checkpoint and back.
#pragma once

#include <winnow/checkpoint.hpp>

#include "io/manifest.hpp"

#include <optional>
#include <string>
#include <vector>

namespace winnow {

struct RunRequest {
  std::vector<std::string> inputs;
  std::string output;  // with {faces} or the like where there are several results
  SimplifyOptions options;
  // Of progressive(); `options` are how it reads then.
  std::optional<ProgressiveOptions> progressive{};
  // Of simplify_sequence(), whose inputs are in the order of the frames; `labels`: see FrameNames.
  std::optional<SequenceOptions> sequence{};
  std::vector<std::string> labels{};
};

// All faces, of which nothing is clustered.
SimplifyOptions reading_options(const ProgressiveOptions& options);

// Names of files are made absolute: the run may go on elsewhere.
void put(Manifest& manifest, const RunRequest& request);
RunRequest request_in(const Manifest& manifest);
ResumableCall call_in(const Manifest& manifest);
// The command that makes it.
const char* command_of(ResumableCall call);

// Size, time and both ends of the content of each input.
void put_inputs(Manifest& manifest, const std::vector<std::string>& inputs);
// Whether every input is a file, which can be read again.
bool inputs_are_files(const Manifest& manifest);
// Throws Error(bad_input) where an input is not what it was. `read`: all of them were read; then
// they may be gone.
void check_inputs(const Manifest& manifest, bool read, const std::string& directory);

// What a run has reported so far, but for its time, memory and scratch.
void put_report(Manifest& manifest, const SimplifyReport& report);
void get_report(const Manifest& manifest, SimplifyReport& report);
void put_report(Manifest& manifest, const SequenceReport& report);
void get_report(const Manifest& manifest, SequenceReport& report);

}  // namespace winnow
