#include <winnow/error.hpp>
#include <winnow/options.hpp>
#include <winnow/progressive.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_json.hpp"
#include "report_text.hpp"

#include <iostream>
#include <memory>
#include <string>

namespace winnow::cli {

namespace {

struct ExtractArguments {
  std::string input, output;
  TableOptions<ExtractOptions> options{extract_options()};
  CommonOptions common;
};

void show(const ExtractReport& report, std::ostream& out) {
  const Lines line(out, 10);
  line("input",
       grouped(report.input.faces) + " faces, " + human_bytes(report.input.bytes_read) + " read");
  line("faces", grouped(report.output.faces));
  line("vertices", grouped(report.output.vertices));
  line("file", human_bytes(report.output.bytes));
  show_quantized(line, report.output.position_error);
  if (!report.attributes.carried.empty()) line("carried", show_list(report.attributes.carried));
  line("time", show_time(report.seconds.total, report.output.faces));
  line("memory", show_memory(report.peak_memory_bytes, report.peak_scratch_bytes));
  line.notes(report.notes);
}

void run_extract(const ExtractArguments& arguments) {
  ExtractOptions options;
  arguments.options.read(options);
  Context context;
  prepare(context, arguments.common, arguments.output);
  const ExtractReport report = with_progress(context, arguments.common, [&] {
    return extract(context, arguments.input, arguments.output, options);
  });
  tell(report, arguments.common, report_stream(arguments.output), show);
}

}  // namespace

void add_extract(CLI::App& app) {
  auto arguments = std::make_shared<ExtractArguments>();
  CLI::App* command =
      app.add_subcommand("extract", "Write a mesh of any count of faces from a progressive file");
  command
      ->add_option("input", arguments->input,
                   "A file of 'winnow progressive', also in .gz or .zst; - is standard input")
      ->required()
      ->type_name("IN");
  command->add_option("-o,--output", arguments->output, output_help())
      ->required()
      ->type_name("OUT");
  arguments->options.add_to(*command);
  arguments->common.add_to(*command, "the output's");
  command->footer(
      "No more of the file is read than the count needs, and a file that is cut short gives what\n"
      "is there.\n"
      "Examples:\n"
      "  winnow extract scan.wpm -o small.ply --faces 123456\n"
      "  winnow extract scan.wpm -o - --ratio 10% | next-stage\n"
      "  winnow extract scan.wpm -o near.stl --error 0.5\n"
      "  head -c 1000000 scan.wpm | winnow extract - -o first.glb --faces 20k");
  command->callback([arguments] { run_extract(*arguments); });
}

}  // namespace winnow::cli
