#include "program.hpp"

#include <winnow/error.hpp>
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

}  // namespace

void CommonOptions::add_to(CLI::App& command, bool with_scratch) {
  owner = &command;
  command
      .add_option("--memory", memory, "Memory to use, mapped input pages included (default 512M)")
      ->type_name("SIZE")
      ->group("Speed and memory (never change the result)");
  command.add_option("--threads", threads, "Number of threads (default: one for each processor)")
      ->check(whole_number())
      ->type_name("N")
      ->group("Speed and memory (never change the result)");
  if (with_scratch) {
    command
        .add_option("--scratch", scratch,
                    "Directory for what does not fit into memory (default: " +
                        std::string(command.get_option_no_throw("--output") != nullptr
                                        ? "the output's)"
                                        : "TMPDIR, or /var/tmp)"))
        ->type_name("DIR")
        ->group("Speed and memory (never change the result)");
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

void prepare(Context& context, const CommonOptions& options, const std::string& output) {
  context.memory = parse_size("--memory", options.memory);
  context.threads = options.threads;
  if (options.threads > 1024) throw Error(ErrorKind::usage, "--threads takes at most 1024");
  context.scratch = options.scratch.empty() ? default_scratch(output) : options.scratch;
  std::error_code ignored;
  if (!options.scratch.empty() && !std::filesystem::is_directory(options.scratch, ignored)) {
    throw Error(ErrorKind::usage, "--scratch: '" + options.scratch + "' is not a directory");
  }
  announce_terminal(*options.owner);
  context.map_input = true;
  running = &context;
  cancel_on_signals();
}

namespace {

constexpr std::array<std::pair<std::string_view, Format>, 7> formats{{{"ply", Format::ply},
                                                                      {"stl", Format::stl},
                                                                      {"obj", Format::obj},
                                                                      {"off", Format::off},
                                                                      {"m", Format::m},
                                                                      {"glb", Format::gltf},
                                                                      {"gltf", Format::gltf}}};
constexpr std::size_t written_formats = 6;

// The first so many, by name.
std::vector<std::string> names_of(std::size_t count) {
  std::vector<std::string> names{"auto"};
  for (const auto& [name, format] : std::span(formats).first(count)) names.emplace_back(name);
  return names;
}

}  // namespace

CLI::Option* add_from(CLI::App& command, std::string& from) {
  return command
      .add_option("--from", from, "Read the input as this format, whatever its content looks like")
      ->check(one_of(names_of(formats.size())))
      ->type_name("FORMAT");
}

Format format_called(const std::string& text) {
  for (const auto& [name, format] : formats) {
    if (text == name) return format;
  }
  return Format::automatic;
}

void OutputOptions::add_to(CLI::App& command, const std::string& group) {
  command.add_option("--to", to, "Output format, where the name's ending does not tell")
      ->check(one_of(names_of(written_formats)))
      ->type_name("FORMAT")
      ->group(group);
  command.add_flag("--ascii", ascii, "Write PLY and STL as text")->group(group);
  command
      .add_option("--positions", positions,
                  "Type of positions (default: the input's; STL and GLB hold floats)")
      ->check(one_of({"float", "double"}))
      ->type_name("TYPE")
      ->group(group);
  command
      .add_option(
          "--compress", compress,
          "How to pack a GLB: none (default) or meshopt (EXT_meshopt_compression, without loss)")
      ->check(one_of({"none", "meshopt"}))
      ->type_name("HOW")
      ->group(group);
  command
      .add_option("--quantize", quantize,
                  "GLB: positions in 1 to 16 bits, normals in 8 (KHR_mesh_quantization)")
      ->type_name("BITS")
      ->group(group);
  command.add_option("--up", up, "GLB: the axis of the model that points up: y (default) or z")
      ->check(CLI::IsMember({"y", "z"}))
      ->type_name("AXIS")
      ->group(group);
  command.add_flag("--force", force, "Replace the output if it exists")->group(group);
}

Encoding OutputOptions::encoding() const {
  Encoding encoding;
  encoding.ascii = ascii;
  if (compress == "meshopt") encoding.compression = Compression::meshopt;
  if (up == "z") encoding.up = UpAxis::z;
  if (!quantize.empty()) {
    const double bits = parse_number("--quantize", quantize, "1 to 16 bits");
    if (!(bits >= 1 && bits <= 16 && bits == std::floor(bits)))
      throw Error(ErrorKind::usage, "--quantize takes 1 to 16 bits, not '" + quantize + "'");
    encoding.quantize = static_cast<unsigned>(bits);
  }
  if (positions == "float") encoding.positions = Positions::floats;
  if (positions == "double") encoding.positions = Positions::doubles;
  return encoding;
}

void refuse_empty_values(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (argument.starts_with("--") && argument.ends_with('='))
      refuse_empty_value(argument.substr(0, argument.size() - 1));
  }
}

void add_commands(CLI::App& app) {
  app.name("winnow");
  app.description("winnow makes huge triangle meshes small, in bounded memory.");
  app.set_version_flag("-V,--version", "winnow " WINNOW_VERSION);
  app.formatter(std::make_shared<HelpFormatter>());  // that of the commands as well
  app.require_subcommand(1);
  app.footer(
      "Try first:\n  winnow simplify scan.ply -o small.ply --faces 500k\n\n'winnow help COMMAND' "
      "or 'winnow "
      "COMMAND --help' "
      "shows the options of a command and\nexamples.");
  add_simplify(app);
  add_resume(app);
  add_convert(app);
  add_info(app);
  add_compare(app);
  add_generate(app);
  for (CLI::App* command : app.get_subcommands({})) {
    command->parse_complete_callback([command] { refuse_empty_values(*command); });
    for (const char* name : output_options) {
      if (CLI::Option* option = command->get_option_no_throw(name)) option->transform(output_name);
    }
  }
}

void tell_error(const std::string& message) {
  std::cerr << "winnow: " + clean(message) + "\n";
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

std::ostream& report_stream(const std::string& output) {
  return output == "-" ? std::cerr : std::cout;
}

}  // namespace winnow::cli
