#include "program.hpp"

#include <winnow/error.hpp>
#include <winnow/parts.hpp>
#include <winnow/version.hpp>

#include "help_formatter.hpp"
#include "numbers.hpp"
#include "usage_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <span>
#include <string_view>
#include <utility>

#include <unistd.h>

namespace winnow::cli {

namespace {

// What the signal handler can reach; only ever the context of the one command that runs.
std::atomic<Context*> running{nullptr};

void on_stop_signal(int /*number*/) {
  Context* context = running.load();
  if (context != nullptr) context->cancel();
}

// All that would end the program where it stands, and leave half an output. One that was ignored at
// the start stays ignored, as nohup and shells ask for.
void cancel_on_signals() {
  struct sigaction action {};
  action.sa_handler = on_stop_signal;  // without SA_RESTART: a waiting read returns
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM, SIGVTALRM, SIGPROF,
                           SIGUSR1, SIGUSR2, SIGIO, SIGPWR}) {
    struct sigaction before {};
    if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler == SIG_DFL)
      ::sigaction(number, &action, nullptr);
  }
}

// "PLY, STL or OBJ"
std::string formats_for(FormatUse use) {
  std::vector<std::string> names;
  for (const Format format : all_values<Format>()) {
    const FormatFacts facts = facts_of(format);
    if (serves(format, use))
      names.emplace_back(use == FormatUse::read ? facts.name : facts.written);
  }
  return either(names);
}

// A mesh that is awaited from a terminal looks like a program that hangs.
void announce_terminal(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    for (const std::string& name : option->results()) {
      const int fd = name == "-" || name == "/dev/stdin" ? STDIN_FILENO : -1;
      if (fd < 0 || ::isatty(fd) != 1) continue;
      std::cerr << "winnow: waiting for a mesh from the terminal; send one through a pipe, name a "
                   "file, or end "
                   "with Ctrl-D\n";
    }
  }
}

std::string default_scratch(const std::string& output) {
  std::error_code ignored;
  const std::filesystem::path path(output);
  const bool regular =
      output != "-" && !output.empty() &&
      (!std::filesystem::exists(path, ignored) || std::filesystem::is_regular_file(path, ignored));
  if (regular) return path.has_parent_path() ? path.parent_path().string() : ".";
  const char* temporary = std::getenv("TMPDIR");
  return temporary != nullptr && *temporary != '\0' ? temporary : "/var/tmp";
}

// By these names standard output is no file to be replaced, whatever it is directed to.
std::string output_name(const std::string& name) {
  constexpr std::array<const char*, 3> standard{"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"};
  return std::find(standard.begin(), standard.end(), name) != standard.end() ? "-" : name;
}

struct Command {
  std::string_view name;
  void (*add)(CLI::App&);
};

constexpr std::array<Command, 11> commands{{{"simplify", add_simplify},
                                            {"resume", add_resume},
                                            {"sequence", add_sequence},
                                            {"convert", add_convert},
                                            {"progressive", add_progressive},
                                            {"extract", add_extract},
                                            {"view", add_view},
                                            {"info", add_info},
                                            {"compare", add_compare},
                                            {"compare-sequence", add_compare_sequence},
                                            {"generate", add_generate}}};

constexpr std::array<const char*, 3> output_options{"--output", "--colored", "--picture"};

[[noreturn]] void refuse_empty_value(const std::string& name) {
  throw Error(ErrorKind::usage, name + " is empty; give it a value, or leave it out");
}

// A script's variable that was never set would else be taken for an option that was left out.
void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string>& values = option->results();
    if (std::find(values.begin(), values.end(), "") != values.end())
      refuse_empty_value(option->get_name());
  }
}

// With what this program was built without.
std::string version_text() {
  std::string without;
  for (const auto& [has, name] :
       {std::pair{has_part(Part::gltf), "glTF"}, std::pair{has_part(Part::compare), "comparing"},
        std::pair{has_generate(), "generate"}, std::pair{has_viewer(), "the viewer"}}) {
    if (!has) without += (without.empty() ? "" : ", ") + std::string(name);
  }
  return "winnow " WINNOW_VERSION + (without.empty() ? "" : " (without " + without + ")");
}

}  // namespace

void CommonOptions::add_to(CLI::App& command, const std::string& scratch) {
  owner = &command;
  surroundings.add_to(command, {"memory", "threads"});
  if (!scratch.empty()) {
    surroundings.add_to(command, {"scratch"});
    surroundings.describe("scratch",
                          "Directory for what does not fit into memory (default: " + scratch + ")");
  }
  command
      .add_option("--progress", progress,
                  "When to show progress: auto (on a terminal), always, never, or json (one JSON "
                  "object a line)")
      ->check(one_of({"auto", "always", "never", "json"}))
      ->type_name("WHEN")
      ->group("Messages");
  command.add_flag("--json", json, "Print a JSON report instead of the summary, also of an error")
      ->group("Messages");
  command.add_flag("-q,--quiet", quiet, "Print no summary and no progress")->group("Messages");
}

void CheckpointOptions::add_to(CLI::App& command) {
  const std::string killed = "Long runs";
  command
      .add_option("--checkpoint", settings.directory,
                  "Save the run's state in this new or empty directory; if it is killed, 'winnow "
                  "resume DIR' "
                  "goes on")
      ->type_name("DIR")
      ->group(killed);
  command
      .add_flag("--keep-checkpoint", settings.keep,
                "Leave the files in DIR when the run is done (default: they are removed)")
      ->group(killed);
}

void prepare(Context& context, const CommonOptions& options, const std::string& output) {
  options.surroundings.read(context);
  std::error_code ignored;
  if (context.scratch.empty()) {
    context.scratch = default_scratch(output);
  } else if (!std::filesystem::is_directory(context.scratch, ignored)) {
    throw Error(ErrorKind::usage, "`scratch`: '" + context.scratch + "' is not a directory");
  }
  announce_terminal(*options.owner);
  context.map_input = true;
  running = &context;
  cancel_on_signals();
}

void refuse_empty_values(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (argument.starts_with("--") && argument.ends_with('='))
      refuse_empty_value(argument.substr(0, argument.size() - 1));
  }
}

void add_commands(CLI::App& app, const std::string& word) {
  app.name("winnow");
  app.description("winnow makes huge triangle meshes small, in bounded memory.");
  app.set_version_flag("-V,--version", version_text());
  app.formatter(std::make_shared<HelpFormatter>());  // that of the commands as well
  app.require_subcommand(1);
  app.footer(
      "Try first:\n  winnow simplify scan.ply -o small.ply --faces 500k\n\n'winnow help COMMAND' "
      "or 'winnow "
      "COMMAND --help' "
      "shows the options of a command and\nexamples.");
  const auto named = [&](const Command& command) { return command.name == word; };
  const bool all = std::none_of(commands.begin(), commands.end(), named);
  for (const Command& command : commands) {
    if (all || named(command)) command.add(app);
  }
  for (CLI::App* command : app.get_subcommands({})) {
    command->parse_complete_callback([command] { refuse_empty_values(*command); });
    for (const char* name : output_options) {
      if (CLI::Option* option = command->get_option_no_throw(name)) option->transform(output_name);
    }
  }
}

void tell_error(const std::string& message) {
  std::cerr << "winnow: " + clean(spoken(message)) + "\n";
}

bool writes_to_standard_output(const CLI::App& command) {
  return std::any_of(output_options.begin(), output_options.end(), [&](const char* name) {
    const CLI::Option* option = command.get_option_no_throw(name);
    return option != nullptr && option->count() > 0 &&
           output_name(option->results().front()) == "-";
  });
}

const CLI::App& parsed_command(const CLI::App& app) {
  const std::vector<const CLI::App*> parsed =
      app.get_subcommands([](const CLI::App* command) { return command->parsed(); });
  return parsed.empty() ? app : *parsed.front();
}

std::string input_help() {
  return formats_for(FormatUse::read) + ", also in .gz or .zst; - is standard input";
}

std::string output_help(FormatUse use) {
  return formats_for(use) + " by the name's ending, also in .gz or .zst; - is standard output";
}

std::ostream& report_stream(const std::string& output) {
  return output == "-" ? std::cerr : std::cout;
}

}  // namespace winnow::cli
