#include <winnow/error.hpp>
#include <winnow/options.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_json.hpp"
#include "report_text.hpp"

#include <iostream>
#include <memory>

namespace winnow::cli {

namespace {

struct ConvertArguments {
  std::string input, output;
  TableOptions<ConvertOptions> options{convert_options()};
  CommonOptions common;
};

void show(const ConvertReport& report, std::ostream& out) {
  const Lines line(out, 10);
  line("input", report.input.format + ", " + human_bytes(report.input.bytes));
  line("faces", grouped(report.output.faces));
  line("vertices",
       grouped(report.output.vertices) + (report.welded ? "  (equal positions are one)" : ""));
  line("file", human_bytes(report.output.bytes));
  show_quantized(line, report.output.position_error);
  if (!report.attributes.carried.empty()) line("carried", show_list(report.attributes.carried));
  line("time", show_time(report.seconds.total, report.input.faces));
  line("memory", show_memory(report.peak_memory_bytes, report.peak_scratch_bytes));
  if (report.input.bad_faces.total() > 0) line("bad faces", show_bad_faces(report.input.bad_faces));
  if (report.doubled_faces > 0)
    line("doubled",
         grouped(report.doubled_faces) + " faces left out that another has all corners of");
  line.notes(report.notes);
}

void run_convert(const ConvertArguments& arguments) {
  ConvertOptions options;
  arguments.options.read(options);
  Context context;
  prepare(context, arguments.common, arguments.output);
  const ConvertReport report = with_progress(context, arguments.common, [&] {
    return convert(context, arguments.input, arguments.output, options);
  });
  tell(report, arguments.common, report_stream(arguments.output), show);
}

}  // namespace

void add_convert(CLI::App& app) {
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command = app.add_subcommand(
      "convert", "Write a mesh of any size in another format, in bounded memory");
  command->add_option("input", arguments->input, input_help())->required()->type_name("IN");
  command->add_option("-o,--output", arguments->output, output_help())
      ->required()
      ->type_name("OUT");
  arguments->options.add_to(*command);
  arguments->common.add_to(*command, "the output's");
  command->footer(
      "Vertices and faces keep their order; bad faces are left out. An STL stores no vertices: "
      "equal\n"
      "positions become one vertex, and no face comes twice. With --compress meshopt faces come in "
      "an\n"
      "order that packs well.\n"
      "Examples:\n"
      "  winnow convert scan.ply -o scan.glb\n"
      "  winnow convert scan.ply -o web.glb --quantize 14 --compress meshopt --up z\n"
      "  winnow convert scan.stl -o scan.ply.zst\n"
      "  winnow convert tile.ply -o tile.obj --positions double");
  command->callback([arguments] { run_convert(*arguments); });
}

}  // namespace winnow::cli
