#include "generate/generate.hpp"
#include "numbers.hpp"
#include "program.hpp"
#include "report_json.hpp"
#include "report_text.hpp"

#include <iostream>
#include <memory>

namespace winnow::cli {

namespace {

struct GenerateArguments {
  std::string output;
  TableOptions<GenerateOptions> options{generate_options()};
  CommonOptions common;
};

void show(const GenerateReport& report, std::ostream& out) {
  out << "  made      " << grouped(report.faces) << " faces, " << grouped(report.vertices)
      << " vertices, " << human_bytes(report.bytes) << "\n  time      "
      << show_seconds(report.seconds) << "  ("
      << show_rate(static_cast<double>(report.faces) / report.seconds) << "faces/s)\n";
}

void run_generate(const GenerateArguments& arguments) {
  GenerateOptions options;
  arguments.options.read(options);

  Context context;
  prepare(context, arguments.common, arguments.output);
  const GenerateReport report = with_progress(
      context, arguments.common, [&] { return generate(context, arguments.output, options); });
  tell(report, arguments.common, report_stream(arguments.output), show);
}

}  // namespace

void add_generate(CLI::App& app) {
  auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* command =
      app.add_subcommand("generate", "Make a surface of any size, for tests and benches");
  arguments->options.add_positional(*command, "surface");
  command->add_option("-o,--output", arguments->output, output_help(FormatUse::generated))
      ->required()
      ->type_name("OUT");
  arguments->options.add_to(*command, {"faces", "seed", "shuffle", "offset", "to", "force"});
  arguments->common.add_to(*command);
  command->footer(
      "Examples:\n"
      "  winnow generate scan --faces 20M -o scan.ply\n"
      "  winnow generate terrain --faces 5M --offset 431000,5412000,300 -o tile.ply\n"
      "  winnow generate scan --faces 1G -o - | winnow simplify - -o small.ply --faces 1M --memory "
      "256M");
  command->callback([arguments] { run_generate(*arguments); });
}

bool has_generate() {
  return true;
}

}  // namespace winnow::cli
