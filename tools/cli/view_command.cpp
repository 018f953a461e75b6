#include <winnow/error.hpp>
#include <winnow/progressive.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_json.hpp"
#include "report_text.hpp"
#include "viewer/export_page.hpp"
#include "viewer/page.hpp"
#include "viewer/page_server.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>

namespace winnow::cli {

namespace {

constexpr std::size_t most_inputs = 2;

struct ViewArguments {
  std::vector<std::string> inputs;
  std::string page;
  std::optional<std::uint16_t> port;
  bool no_browser = false, force = false;
  CommonOptions common;
};

// A folder in scratch that vanishes with all that is in it.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::string& scratch) : path_(scratch + "/winnow-view-XXXXXX") {
    if (::mkdtemp(path_.data()) == nullptr)
      throw Error(ErrorKind::resources, "`scratch`: no folder can be made in '" + scratch + "'");
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

std::string last_part(const std::string& input) {
  return input == "-" ? "standard input" : std::filesystem::path(input).filename().string();
}

// What is no progressive file becomes one in scratch, whose name is gone when it is open.
viewer::ShownFile shown_file(Context& context, const ViewArguments& arguments,
                             const std::string& input) {
  if (is_progressive(input)) {
    for (const std::string& note : progressive_info(context, input).notes)
      std::cerr << "winnow: '" << input << "': " << note << "\n";
    return {input, last_part(input)};
  }
  const ScratchFolder folder(context.scratch);
  const std::string made = folder.file("mesh.wpm");
  const ProgressBar bar(context, arguments.common);
  copy_or_make_progressive(context, input, made);
  for (const std::string& note : progressive_info(context, made).notes)
    std::cerr << "winnow: '" << input << "': " << note << "\n";
  return {made, last_part(input)};
}

// Where there is a desktop. It is told what to open and left alone.
bool open_browser(const std::string& address) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return false;
  std::string program = "xdg-open", target = address;
  const std::array<char*, 3> words{program.data(), target.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, program.c_str(), nullptr, nullptr, words.data(), environ) != 0)
    return false;
  int status = 0;
  return ::waitpid(child, &status, 0) == child && status == 0;
}

void tell(const ViewArguments& arguments, const char* what, const std::string& place) {
  std::ostream& out = report_stream(arguments.page);
  if (arguments.common.json) {
    Json report;
    report[what] = place;
    print(report, arguments.common, out);
  } else if (!arguments.common.quiet) {
    const Lines line(out, 10);
    line(what, place);
  }
  out.flush();
}

void serve(const Context& context, const ViewArguments& arguments,
           std::vector<viewer::ShownFile> files) {
  viewer::PageServer server(viewer::page(), std::move(files), arguments.port.value_or(0));
  const std::string address = server.address();
  tell(arguments, "address", address);
  if (!arguments.common.quiet && !arguments.common.json)
    std::cout << "  Ctrl-C ends it" << std::endl;
  if (!arguments.no_browser && !open_browser(address))
    std::cerr << "winnow: no browser could be opened; open the address in one\n";
  server.run([&context] { return context.cancelled(); });
}

void run_view(const ViewArguments& arguments) {
  if (viewer::page().empty())
    throw Error(ErrorKind::failed,
                "this winnow was built without the viewer, since its npm packages were not there; "
                "run 'npm ci --prefix tools/viewer' where its source is, and build it again");
  if (arguments.inputs.size() > most_inputs)
    throw Error(ErrorKind::usage, "two meshes at most are shown side by side");
  if (arguments.page.empty() && arguments.force)
    throw Error(ErrorKind::usage, "--force goes with --export, which writes a page");
  if (!arguments.page.empty() && (arguments.port || arguments.no_browser))
    throw Error(ErrorKind::usage,
                "--port and --no-browser do not go with --export: no page is served");
  Context context;
  prepare(context, arguments.common, arguments.page);
  std::optional<viewer::ExportedPage> page;
  if (!arguments.page.empty())
    page.emplace(context, arguments.page, arguments.force, arguments.inputs);
  std::vector<viewer::ShownFile> files;
  for (const std::string& input : arguments.inputs)
    files.push_back(shown_file(context, arguments, input));
  if (!page) return serve(context, arguments, std::move(files));
  page->write(viewer::page(), files);
  tell(arguments, "page", arguments.page);
}

}  // namespace

bool has_viewer() {
  return !viewer::page().empty();
}

void add_view(CLI::App& app) {
  auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command =
      app.add_subcommand("view", "Look at a mesh in the browser, at every level of detail");
  command
      ->add_option("input", arguments->inputs,
                   "A file of 'winnow progressive', or a mesh that one is made of first: " +
                       input_help() + "; a second one is shown beside it")
      ->required()
      ->type_name("IN");
  command
      ->add_option("--export", arguments->page,
                   "Write a page with the mesh in it instead, to be sent or put on a web server")
      ->type_name("PAGE.html");
  command->add_flag("--force", arguments->force, "Replace PAGE.html if it exists");
  command->add_option("--port", arguments->port, "Serve at this port (default: one that is free)")
      ->type_name("N")
      ->check(CLI::Range(0, 65535).description(""));
  command->add_flag("--no-browser", arguments->no_browser,
                    "Open no browser, only print the address");
  arguments->common.add_to(*command, "TMPDIR, else /var/tmp");
  command->footer(
      "The page is served to this machine alone, until Ctrl-C, which ends the command with 0.\n"
      "Large files appear coarse first, and no more of them is read than is seen. A .wpm file can\n"
      "also lie on any web server with ranges, beside a page: PAGE.html?mesh=scan.wpm\n"
      "Examples:\n"
      "  winnow view scan.wpm\n"
      "  winnow view scan.ply\n"
      "  winnow view scan.wpm --export page.html");
  command->callback([arguments] { run_view(*arguments); });
}

}  // namespace winnow::cli
