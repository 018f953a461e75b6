// What all commands share: the options of speed and memory, signals, progress on the terminal.
#pragma once

#include <winnow/checkpoint.hpp>
#include <winnow/context.hpp>
#include <winnow/simplify.hpp>

#include "table_options.hpp"

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace winnow::cli {

// Texts of options that mean the same in every command; turned into a Context by prepare().
struct CommonOptions {
  const CLI::App* owner = nullptr;  // the command that has them
  TableOptions<Context> surroundings{context_options()};
  std::string progress = "auto";
  bool quiet = false;
  bool json = false;

  // `scratch`: where it goes by default, in words; without them the command has no scratch.
  void add_to(CLI::App& command, const std::string& scratch = "");
};

// The options of a run that can be resumed.
struct CheckpointOptions {
  Checkpoint settings;

  void add_to(CLI::App& command);
  [[nodiscard]] bool given() const { return !settings.directory.empty(); }
  // Scratch is in the checkpoint's directory, where nothing else was said.
  void prepare(Context& context, const CommonOptions& common) const {
    if (given() && !common.surroundings.given("scratch")) context.scratch.clear();
  }
};

// Progress on standard error while it lives.
class ProgressBar {
 public:
  ProgressBar(Context& context, const CommonOptions& options);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

// What call() returns, which shows progress meanwhile.
template <typename Call>
auto with_progress(Context& context, const CommonOptions& options, const Call& call) {
  const ProgressBar bar(context, options);
  return call();
}

// Fills `context` and lets SIGINT and SIGTERM cancel it. `output` decides where scratch goes by
// default: beside a regular file, else to TMPDIR or /var/tmp (/tmp may be memory). Throws
// Error(usage).
void prepare(Context& context, const CommonOptions& options, const std::string& output);

// What every command says of its input, and of its output.
std::string input_help();
std::string output_help(FormatUse use = FormatUse::written);

// For reports: standard output, or standard error where standard output carries the mesh.
std::ostream& report_stream(const std::string& output);

// Whether an output of `command`, as far as its options were read, is standard output.
bool writes_to_standard_output(const CLI::App& command);

// The command that the line named which `app` has parsed; where it named none, `app`.
const CLI::App& parsed_command(const CLI::App& app);

// Thrown where all that there is to say was said, but the program is not to end with 0.
struct Ended {
  int code = 0;
};

// What every error begins with.
void tell_error(const std::string& message);

// One file a command.
void add_simplify(CLI::App& app);
void add_resume(CLI::App& app);
void add_info(CLI::App& app);
void add_compare(CLI::App& app);
void add_generate(CLI::App& app);
bool has_generate();  // which may be left out when the program is built
void add_convert(CLI::App& app);
void add_view(CLI::App& app);
bool has_viewer();  // the page of it
void add_progressive(CLI::App& app);
void add_extract(CLI::App& app);
void add_sequence(CLI::App& app);
void add_compare_sequence(CLI::App& app);
// "--" of compare-sequence as the option that it stands for.
void name_simplified_frames(std::vector<std::string>& words);

// The whole command line; of the commands only the one that `word` names, if it names one.
void add_commands(CLI::App& app, const std::string& word = "");

// Throws Error(usage) for "--option=", which the parser would give the next word: an input could
// become the output.
void refuse_empty_values(const std::vector<std::string>& arguments);

}  // namespace winnow::cli
