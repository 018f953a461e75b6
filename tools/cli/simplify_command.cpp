#include <winnow/options.hpp>

#include "program.hpp"
#include "simplify_report.hpp"
#include "table_options.hpp"

#include <memory>
#include <string>
#include <vector>

namespace winnow::cli {

namespace {

struct SimplifyArguments {
  std::vector<std::string> inputs;
  std::string output;
  CheckpointOptions checkpoint;
  bool dry_run = false;
  TableOptions<SimplifyOptions> options{simplify_options()};
  CommonOptions common;
};

void run_simplify(const SimplifyArguments& arguments) {
  SimplifyOptions options;
  arguments.options.read(options);
  Context context;
  prepare(context, arguments.common, arguments.output);
  if (arguments.dry_run) {
    tell(plan_simplify(context, arguments.inputs, arguments.output, options), arguments.common);
    return;
  }
  SimplifyReport report;
  {
    const ProgressBar bar(context, arguments.common);
    arguments.checkpoint.prepare(context, arguments.common);
    report = arguments.checkpoint.given()
                 ? simplify(context, arguments.inputs, arguments.output, options,
                            arguments.checkpoint.settings)
                 : simplify(context, arguments.inputs, arguments.output, options);
  }
  tell(report, arguments.common);
}

}  // namespace

void add_simplify(CLI::App& app) {
  auto arguments = std::make_shared<SimplifyArguments>();
  CLI::App* command =
      app.add_subcommand("simplify", "Make a mesh of any size small, in bounded memory");
  command->add_option("input", arguments->inputs, input_help() + "; several files are one model")
      ->required()
      ->type_name("IN");
  command->add_option("-o,--output", arguments->output, output_help())
      ->required()
      ->type_name("OUT");

  arguments->options.add_to(*command);
  arguments->checkpoint.add_to(*command);
  command
      ->add_flag("--dry-run", arguments->dry_run,
                 "Show passes, memory and scratch, and write nothing")
      ->group("Messages");
  arguments->common.add_to(*command, "the output's");
  command->footer(
      "Examples:\n"
      "  winnow simplify scan.ply -o small.ply --faces 500k\n"
      "  winnow simplify scan.ply -o small.ply --ratio 1% --memory 256M\n"
      "  winnow simplify scan.ply -o small.ply --error 0.1%\n"
      "  winnow simplify scan.ply -o small.ply --faces 1M --detail full\n"
      "  winnow simplify scan.stl -o small.ply --faces 1M --refine none\n"
      "  winnow simplify soup.stl -o small.ply --faces 50k --weld 0.01\n"
      "  winnow simplify bone.ply -o small.ply --ratio 2% --topology free\n"
      "  winnow simplify scan.ply -o small.ply --faces 100M --checkpoint kept\n"
      "  winnow simplify part-*.ply -o all.ply --faces 5M --crop 0,0,-10,500,500,90\n"
      "  zstdcat scan.ply.zst | winnow simplify - -o - --cell 2.5 | next-stage");
  command->callback([arguments] { run_simplify(*arguments); });
}

}  // namespace winnow::cli
