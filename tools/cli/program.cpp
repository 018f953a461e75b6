#include "program.hpp"

#include <winnow/error.hpp>
#include <winnow/version.hpp>

#include "numbers.hpp"

#include <algorithm>
#include <array>
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

[[noreturn]] void refuse_empty_value(const std::string& name) {
  throw Error(ErrorKind::usage, name + " is empty; give it a value, or leave it out");
}

// A script's variable that was never set would else be taken for an option that was left out.
void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string>& values = option->results();
    if (std::find(values.begin(), values.end(), "") != values.end()) refuse_empty_value(option->get_name());
  }
}

}  // namespace

void CommonOptions::add_to(CLI::App& command, bool with_scratch) {
  command.add_option("--memory", memory, "Memory to use, tables and mapped pages together (default 512M)")
      ->type_name("SIZE")
      ->group("Speed and memory (never change the result)");
  command.add_option("--threads", threads, "Threads to use (default: all processors)")
      ->type_name("N")
      ->group("Speed and memory (never change the result)");
  if (with_scratch) {
    command
        .add_option("--scratch", scratch,
                    "Directory for what does not fit into memory (default: that of the output)")
        ->type_name("DIR")
        ->group("Speed and memory (never change the result)");
  }
  command
      .add_option("--progress", progress,
                  "auto (on a terminal), always, never, or json (a line of JSON each)")
      ->check(CLI::IsMember({"auto", "always", "never", "json"}))
      ->type_name("WHEN")
      ->group("Messages");
  command.add_flag("--json", json, "One machine-readable report instead of the summary")->group("Messages");
  command.add_flag("-q,--quiet", quiet, "No summary and no progress")->group("Messages");
}

void prepare(Context& context, const CommonOptions& options, const std::string& output) {
  context.memory = parse_size("--memory", options.memory);
  context.threads = options.threads;
  if (options.threads > 1024) throw Error(ErrorKind::usage, "--threads takes at most 1024");
  context.scratch = options.scratch.empty() ? default_scratch(output) : options.scratch;
  std::error_code ignored;
  if (!options.scratch.empty() && !std::filesystem::is_directory(options.scratch, ignored)) {
    throw Error(ErrorKind::usage, "--scratch: '" + options.scratch + "' is not a directory");
  }
  context.map_input = true;
  running = &context;
  struct sigaction action {};
  action.sa_handler = on_stop_signal;  // without SA_RESTART: a waiting read returns
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  // A terminal that goes away ends the run, unless nohup was asked to keep it.
  struct sigaction before {};
  if (::sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
    ::sigaction(SIGHUP, &action, nullptr);
}

namespace {

constexpr std::array<std::pair<std::string_view, Format>, 7> formats{{{"ply", Format::ply},
                                                                      {"stl", Format::stl},
                                                                      {"obj", Format::obj},
                                                                      {"off", Format::off},
                                                                      {"glb", Format::gltf},
                                                                      {"gltf", Format::gltf},
                                                                      {"m", Format::m}}};
constexpr std::size_t written_formats = 5;
constexpr const char* input_formats = "ply, stl, obj, off, m, gltf";

Format format_called(const std::string& text, std::size_t known, const std::string& refusal) {
  if (text.empty() || text == "auto") return Format::automatic;
  for (const auto& [name, format] : std::span(formats).first(known)) {
    if (text == name) return format;
  }
  throw Error(ErrorKind::usage, refusal + ", not '" + text + "'");
}

}  // namespace

CLI::Option* add_from(CLI::App& command, std::string& from) {
  return command
      .add_option("--from", from,
                  std::string("Read the input as this, whatever its content looks like: ") + input_formats)
      ->type_name("FORMAT");
}

Format parse_input_format(const std::string& text) {
  return format_called(text, formats.size(), std::string("--from takes one of ") + input_formats);
}

Format parse_output_format(const std::string& text) {
  return format_called(text, written_formats, "--to takes one of ply, stl, obj, off, glb");
}

void OutputOptions::add_to(CLI::App& command, const std::string& group) {
  command.add_option("--to", to, "Output format, where the name does not tell: ply, stl, obj, off, glb")
      ->type_name("FORMAT")
      ->group(group);
  command.add_flag("--ascii", ascii, "PLY and STL as text")->group(group);
  command
      .add_option("--positions", positions,
                  "Type of positions: float or double (default: the input's; STL and GLB hold floats)")
      ->check(CLI::IsMember({"float", "double"}))
      ->type_name("TYPE")
      ->group(group);
  command
      .add_option("--compress", compress,
                  "How a GLB is packed: none (default) or meshopt (EXT_meshopt_compression, without loss)")
      ->check(CLI::IsMember({"none", "meshopt"}))
      ->type_name("HOW")
      ->group(group);
  command.add_flag("--force", force, "Replace the output if it exists")->group(group);
}

Encoding OutputOptions::encoding() const {
  Encoding encoding;
  encoding.ascii = ascii;
  if (compress == "meshopt") encoding.compression = Compression::meshopt;
  if (positions == "float") encoding.positions = Positions::floats;
  if (positions == "double") encoding.positions = Positions::doubles;
  return encoding;
}

void refuse_empty_values(std::span<char* const> arguments) {
  for (const std::string_view argument : arguments) {
    if (argument.starts_with("--") && argument.ends_with('='))
      refuse_empty_value(std::string(argument.substr(0, argument.size() - 1)));
  }
}

void add_commands(CLI::App& app) {
  app.name("winnow");
  app.description("winnow makes huge triangle meshes small, in bounded memory.");
  app.set_version_flag("--version", "winnow " WINNOW_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Try first:\n  winnow simplify scan.ply -o small.ply --faces 500k\n\n'winnow COMMAND --help' shows the "
      "options of a command and examples.");
  add_simplify(app);
  add_resume(app);
  add_convert(app);
  add_info(app);
  add_compare(app);
  add_generate(app);
  for (CLI::App* command : app.get_subcommands({})) {
    command->parse_complete_callback([command] { refuse_empty_values(*command); });
    for (const char* name : {"--output", "--colored", "--picture"}) {
      if (CLI::Option* option = command->get_option_no_throw(name)) option->transform(output_name);
    }
  }
}

std::ostream& report_stream(const std::string& output) {
  return output == "-" ? std::cerr : std::cout;
}

}  // namespace winnow::cli
