#include <winnow/error.hpp>
#include <winnow/options.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_json.hpp"
#include "report_text.hpp"
#include "sequence_report.hpp"

#include <iostream>
#include <memory>

namespace winnow::cli {

namespace {

struct SequenceArguments {
  std::vector<std::string> inputs;
  std::string output;
  TableOptions<SequenceOptions> options{sequence_options()};
  CheckpointOptions checkpoint;
  CommonOptions common;
};

void show(const SequenceReport& report, std::ostream& out) {
  const Lines line(out, 10);
  line("frames", grouped(report.input.frames) + "  (" + report.input.format + ", " +
                     human_bytes(report.input.bytes) + ")");
  line("faces",
       grouped(report.input.faces) + " -> " + grouped(report.output.faces) + " in each frame");
  line("vertices", grouped(report.input.vertices) + " -> " + grouped(report.output.vertices));
  line("area", show_length(report.area.input) + " -> " + show_length(report.area.output) +
                   " in the first frame");
  if (const std::string lost = show_lost(report.lost); !lost.empty()) line("lost", lost);
  line("files", human_bytes(report.output.bytes));
  if (report.resumed) line("resumed", show_resumed(*report.resumed));
  line("time", show_time(report.seconds.total, report.input.faces * report.input.frames));
  line("memory", show_memory(report.peak_memory_bytes, report.peak_scratch_bytes));
  if (report.bad_faces > 0)
    line("bad faces", grouped(report.bad_faces) + " repeat a vertex or name none; left out");
  if (report.joined > 0)
    line("joined", grouped(report.joined) +
                       (report.joined == 1 ? " vertex that is" : " vertices that are") +
                       " at the place of another in every frame");
  line.notes(report.notes);
}

}  // namespace

void tell(const SequenceReport& report, const CommonOptions& options) {
  // One GLB may go to standard output.
  const std::string& first = report.output.names.front();
  tell(report, options, report_stream(first), show);
}

namespace {

void run_sequence(const SequenceArguments& arguments) {
  SequenceOptions options;
  arguments.options.read(options);
  Context context;
  prepare(context, arguments.common, arguments.output);
  arguments.checkpoint.prepare(context, arguments.common);
  const SequenceReport report = with_progress(context, arguments.common, [&] {
    return arguments.checkpoint.given()
               ? simplify_sequence(context, arguments.inputs, arguments.output, options,
                                   arguments.checkpoint.settings)
               : simplify_sequence(context, arguments.inputs, arguments.output, options);
  });
  tell(report, arguments.common);
}

}  // namespace

void add_sequence(CLI::App& app) {
  auto arguments = std::make_shared<SequenceArguments>();
  CLI::App* command = app.add_subcommand(
      "sequence", "Simplify all frames of a mesh that moves alike, in bounded memory");
  command
      ->add_option("input", arguments->inputs,
                   "The frames, a file each, with the same vertices and faces, in the order of the "
                   "number in their names; or one glTF with morph targets")
      ->required()
      ->type_name("FRAME");
  command
      ->add_option("-o,--output", arguments->output,
                   "The files of the result: {frame} in the name stands for the number of each "
                   "frame; or one GLB that plays them")
      ->required()
      ->type_name("OUT");
  arguments->options.add_to(*command);
  arguments->checkpoint.add_to(*command);
  arguments->common.add_to(*command, "the outputs'");
  command->footer(
      "All frames of the result have the same faces. An edge is collapsed where that costs least "
      "in the\n"
      "sum over frames, and only if it turns no face of any frame by more than 90 degrees.\n"
      "Examples:\n"
      "  winnow sequence frame-*.ply -o 'small-{frame}.ply' --faces 5k\n"
      "  winnow sequence walk/*.obj -o 'small/{frame}.ply.zst' --ratio 10% --memory 2G\n"
      "  winnow sequence walk/*.obj -o walk.glb --faces 5k\n"
      "  winnow sequence clip.glb -o small.glb --ratio 10%\n"
      "  winnow sequence walk/*.obj -o 'small/{frame}.ply' --ratio 10% --checkpoint kept");
  command->callback([arguments] { run_sequence(*arguments); });
}

}  // namespace winnow::cli
