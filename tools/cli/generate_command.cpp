#include <winnow/error.hpp>
#include <winnow/generate.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_text.hpp"
#include "usage_errors.hpp"

#include <iostream>
#include <memory>

namespace winnow::cli {

namespace {

struct GenerateArguments {
  std::string surface, output, to;
  std::string faces = "1M";
  std::vector<double> offset;
  std::uint32_t seed = 1;
  bool shuffle = false, force = false;
  CommonOptions common;
};

void run_generate(const GenerateArguments& arguments) {
  GenerateOptions options;
  options.surface = arguments.surface == "scan"      ? Surface::scan
                    : arguments.surface == "terrain" ? Surface::terrain
                                                     : Surface::part;
  options.faces = parse_count("--faces", arguments.faces);
  options.seed = arguments.seed;
  options.to = format_called(arguments.to);
  options.shuffle = arguments.shuffle;
  options.force = arguments.force;
  for (std::size_t axis = 0; axis < arguments.offset.size(); ++axis)
    options.offset[axis] = arguments.offset[axis];

  Context context;
  prepare(context, arguments.common, arguments.output);
  GenerateReport report;
  {
    const ProgressBar bar(context, arguments.common);
    report = generate(context, arguments.output, options);
  }
  std::ostream& out = report_stream(arguments.output);
  if (arguments.common.json) {
    Json json = json_of_output(report, arguments.output);
    json["seconds"] = report.seconds;
    print(json, arguments.common, out);
  } else if (!arguments.common.quiet) {
    out << "  made      " << show_count(report.faces) << " faces, " << show_count(report.vertices)
        << " vertices, " << show_bytes(report.bytes) << "\n  time      "
        << show_seconds(report.seconds) << "  ("
        << show_rate(static_cast<double>(report.faces) / report.seconds) << "faces/s)\n";
  }
}

}  // namespace

void add_generate(CLI::App& app) {
  auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* command =
      app.add_subcommand("generate", "Make a surface of any size, for tests and benches");
  command
      ->add_option("surface", arguments->surface,
                   "What to make: scan (closed, curved, noisy), terrain (with a boundary) or part "
                   "(like CAD)")
      ->required()
      ->check(one_of({"scan", "terrain", "part"}))
      ->type_name("SURFACE");
  command
      ->add_option("-o,--output", arguments->output,
                   "PLY, STL, OBJ, OFF or .m by the name's ending, also in .gz or .zst; - is "
                   "standard output")
      ->required()
      ->type_name("OUT");
  const std::string result = "What the result is";
  command
      ->add_option("--faces", arguments->faces,
                   "Make about this many faces: 500k, 20M, 1G (default 1M)")
      ->type_name("N")
      ->group(result);
  command
      ->add_option("--seed", arguments->seed,
                   "Another number makes another surface of the same kind (default 1)")
      ->check(whole_number())
      ->type_name("N")
      ->group(result);
  command->add_flag("--shuffle", arguments->shuffle, "Write the faces in a scattered order")
      ->group(result);
  command
      ->add_option("--offset", arguments->offset,
                   "Add this to every position, as in georeferenced scans; PLY then holds doubles")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,Z")
      ->group(result);
  command->add_option("--to", arguments->to, "Output format, where the name's ending does not tell")
      ->check(one_of({"auto", "ply", "stl", "obj", "off", "m"}))
      ->type_name("FORMAT")
      ->group(result);
  command->add_flag("--force", arguments->force, "Replace the output if it exists")->group(result);
  arguments->common.add_to(*command, false);
  command->footer(
      "Examples:\n"
      "  winnow generate scan --faces 20M -o scan.ply\n"
      "  winnow generate terrain --faces 5M --offset 431000,5412000,300 -o tile.ply\n"
      "  winnow generate scan --faces 1G -o - | winnow simplify - -o small.ply --faces 1M --memory "
      "256M");
  command->callback([arguments] { run_generate(*arguments); });
}

}  // namespace winnow::cli
