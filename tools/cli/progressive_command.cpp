#include <winnow/error.hpp>
#include <winnow/options.hpp>
#include <winnow/progressive.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "progressive_report.hpp"
#include "report_json.hpp"
#include "report_text.hpp"

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace winnow::cli {

namespace {

struct ProgressiveArguments {
  std::vector<std::string> inputs;
  std::string output;
  TableOptions<ProgressiveOptions> options{progressive_options()};
  CheckpointOptions checkpoint;
  CommonOptions common;
};

void show(const ProgressiveReport& report, std::ostream& out) {
  const Lines line(out, 10);
  line("input", report.input.format + ", " + human_bytes(report.input.bytes));
  line("faces", grouped(report.output.base_faces) + " to " + grouped(report.output.faces));
  line("vertices", grouped(report.output.base_vertices) + " to " + grouped(report.output.vertices));
  line("file",
       human_bytes(report.output.bytes) + " in " + grouped(report.output.chunks) + " chunks");
  show_quantized(line, report.output.position_error);
  if (!report.attributes.carried.empty()) line("carried", show_list(report.attributes.carried));
  if (report.resumed) line("resumed", show_resumed(*report.resumed));
  line("time", show_time(report.seconds.total, report.input.faces));
  line("memory", show_memory(report.peak_memory_bytes, report.peak_scratch_bytes));
  if (report.input.cropped_faces > 0)
    line("cropped", grouped(report.input.cropped_faces) + " faces, not wholly inside of the box");
  if (report.weld.distance > 0) {
    line("welded", grouped(report.weld.vertices) + " vertices nearer than " +
                       show_length(report.weld.distance) + " to another; " +
                       grouped(report.weld.faces) + " faces collapsed");
  }
  if (report.input.bad_faces.total() > 0) line("bad faces", show_bad_faces(report.input.bad_faces));
  line.notes(report.notes);
}

}  // namespace

void tell(const ProgressiveReport& report, const CommonOptions& options) {
  tell(report, options, report_stream(report.output.name), show);
}

namespace {

void run_progressive(const ProgressiveArguments& arguments) {
  ProgressiveOptions options;
  arguments.options.read(options);
  Context context;
  prepare(context, arguments.common, arguments.output);
  arguments.checkpoint.prepare(context, arguments.common);
  const ProgressiveReport report = with_progress(context, arguments.common, [&] {
    return arguments.checkpoint.given()
               ? progressive(context, arguments.inputs, arguments.output, options,
                             arguments.checkpoint.settings)
               : progressive(context, arguments.inputs, arguments.output, options);
  });
  tell(report, arguments.common);
}

}  // namespace

void add_progressive(CLI::App& app) {
  auto arguments = std::make_shared<ProgressiveArguments>();
  CLI::App* command = app.add_subcommand(
      "progressive", "Store all levels of detail of a mesh of any size in one file");
  command
      ->add_option("input", arguments->inputs,
                   input_help() + "; several files are read as one model")
      ->required()
      ->type_name("IN");
  command
      ->add_option("-o,--output", arguments->output,
                   "The progressive file, OUT.wpm say; - is standard output")
      ->required()
      ->type_name("OUT");
  arguments->options.add_to(*command);
  arguments->checkpoint.add_to(*command);
  arguments->common.add_to(*command, "the output's");
  command->footer(
      "'winnow extract' writes any count of faces between the coarsest mesh and all of them. "
      "Equal\n"
      "positions become one vertex. The beginning of the file is a coarser mesh; 'winnow info' "
      "tells\n"
      "how many bytes a count needs.\n"
      "Examples:\n"
      "  winnow progressive scan.ply -o scan.wpm\n"
      "  winnow progressive scan.ply -o scan.wpm --base 200 --bits 16\n"
      "  winnow progressive scan.ply -o scan.wpm --checkpoint kept\n"
      "  winnow extract scan.wpm -o small.ply --faces 100k");
  command->callback([arguments] { run_progressive(*arguments); });
}

}  // namespace winnow::cli
