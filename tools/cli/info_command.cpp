#include <winnow/error.hpp>
#include <winnow/info.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_text.hpp"

#include <algorithm>
#include <iostream>
#include <memory>

namespace winnow::cli {

namespace {

struct InfoArguments {
  std::string input, from;
  CommonOptions common;
};

Json json_of(const InfoReport& report, const std::string& name) {
  Json json{{"file", name},
            {"format", report.format},
            {"bytes", report.bytes},
            {"faces", report.faces},
            {"vertices", report.vertices},
            {"bad_faces", json_of_bad_faces(report.bad_faces)},
            {"zero_area", report.zero_area},
            {"box", nullptr},
            {"area", report.area},
            {"mean_edge", report.mean_edge},
            {"attributes", report.attributes},
            {"edges", nullptr}};
  if (report.has_box) json["box"] = {{"min", report.box_min}, {"max", report.box_max}};
  if (report.edges) {
    json["edges"] = {{"total", report.edges->total},
                     {"boundary", report.edges->boundary},
                     {"non_manifold", report.edges->non_manifold}};
  } else {
    json["edges_memory"] = report.edges_memory;
  }
  json["seconds"] = report.seconds;
  json["peak_memory_bytes"] = report.peak_memory_bytes;
  json["notes"] = report.notes;
  return json;
}

void show(const InfoReport& report, std::ostream& out) {
  const Lines line(out, 12);
  line("format", report.format + ", " + show_bytes(report.bytes));
  line("faces", show_count(report.faces));
  if (report.vertices > 0) line("vertices", show_count(report.vertices));
  if (report.has_box) {
    std::array<double, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = report.box_max[axis] - report.box_min[axis];
    const int digits =
        digits_for({report.box_min, report.box_max}, *std::max_element(size.begin(), size.end()));
    line("box", show_place(report.box_min, digits) + "  to  " + show_place(report.box_max, digits));
    line("size", show_place(size));
  }
  line("area", show_length(report.area));
  line("mean edge", show_length(report.mean_edge));
  if (report.edges) {
    line("edges", show_count(report.edges->total) + ", of them " + show_count(report.edges->boundary) +
                      " boundary and " + show_count(report.edges->non_manifold) + " non-manifold");
  } else {
    line("edges",
         "not counted: that takes --memory " + show_count((report.edges_memory + (1 << 20) - 1) >> 20) + "M");
  }
  const BadFaces& bad = report.bad_faces;
  line("bad faces", bad.total() == 0
                        ? "none"
                        : show_count(bad.degenerate) + " repeat a corner, " + show_count(bad.non_finite) +
                              " are not finite, " + show_count(bad.out_of_range) +
                              " name a vertex that does not exist");
  if (report.zero_area > 0) line("zero area", show_count(report.zero_area) + " faces");
  for (const std::string& attribute : report.attributes) line("also", attribute);
  line.notes(report.notes);
}

void run_info(const InfoArguments& arguments) {
  Context context;
  prepare(context, arguments.common, "-");
  InfoReport report;
  {
    const ProgressBar bar(context, arguments.common);
    report = info(context, arguments.input, format_called(arguments.from));
  }
  if (arguments.common.json) {
    print(json_of(report, arguments.input), arguments.common, std::cout);
  } else if (!arguments.common.quiet) {
    show(report, std::cout);
  }
}

}  // namespace

void add_info(CLI::App& app) {
  auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command = app.add_subcommand("info", "Tell what is in a mesh file of any size");
  command->add_option("input", arguments->input, input_help)->required()->type_name("IN");
  add_from(*command, arguments->from);
  arguments->common.add_to(*command, true);
  command->footer(
      "Examples:\n"
      "  winnow info scan.ply\n"
      "  winnow info scan.stl --json\n"
      "  zstdcat scan.ply.zst | winnow info - --memory 2G");
  command->callback([arguments] { run_info(*arguments); });
}

}  // namespace winnow::cli
