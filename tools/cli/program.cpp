#include "program.hpp"

#include <winnow/error.hpp>

#include "numbers.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
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
}

Format parse_input_format(const std::string& option, const std::string& text) {
  constexpr std::array<std::pair<std::string_view, Format>, 7> formats{{{"auto", Format::automatic},
                                                                        {"ply", Format::ply},
                                                                        {"stl", Format::stl},
                                                                        {"obj", Format::obj},
                                                                        {"off", Format::off},
                                                                        {"m", Format::m},
                                                                        {"gltf", Format::gltf}}};
  if (text.empty()) return Format::automatic;
  for (const auto& [name, format] : formats) {
    if (text == name) return format;
  }
  throw Error(ErrorKind::usage, option + " takes one of " + input_formats + ", not '" + text + "'");
}

Format parse_output_format(const std::string& option, const std::string& text) {
  if (text.empty() || text == "auto") return Format::automatic;
  if (text == "ply") return Format::ply;
  if (text == "stl") return Format::stl;
  throw Error(ErrorKind::usage, option + " takes ply or stl, not '" + text + "'");
}

std::ostream& report_stream(const std::string& output) {
  return output == "-" ? std::cerr : std::cout;
}

}  // namespace winnow::cli
