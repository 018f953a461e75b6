#include <winnow/error.hpp>
#include <winnow/info.hpp>
#include <winnow/options.hpp>
#include <winnow/progressive.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_json.hpp"
#include "report_text.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace winnow::cli {

namespace {

struct InfoArguments {
  std::vector<std::string> inputs;
  TableOptions<ConvertOptions> options{convert_options()};
  CommonOptions common;
};

std::string show_watertight(const InfoReport& report) {
  if (report.edges.total == 0) return "no: there is no surface";
  if (report.watertight) return "yes: every edge has two faces";
  std::string text = "no: ";
  if (report.edges.boundary > 0) text += grouped(report.edges.boundary) + " edges have one face";
  if (report.edges.boundary > 0 && report.edges.non_manifold > 0) text += ", ";
  if (report.edges.non_manifold > 0)
    text += grouped(report.edges.non_manifold) + " have three or more";
  return text;
}

std::string show_volume(const InfoReport& report) {
  if (report.volume)
    return show_length(*report.volume) + (*report.volume < 0 ? "  (the faces look inward)" : "");
  return report.watertight ? "not known: neighbouring faces look to different sides"
                           : "none: the surface is not closed";
}

void show(const InfoReport& report, std::ostream& out) {
  const Lines line(out, 12);
  line("format", report.format + ", " + human_bytes(report.bytes));
  line("faces", grouped(report.faces));
  if (report.vertices > 0) line("vertices", grouped(report.vertices));
  if (report.box) {
    const auto& [min, max] = *report.box;
    std::array<double, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = max[axis] - min[axis];
    const int digits = digits_for({min, max}, *std::max_element(size.begin(), size.end()));
    line("box", show_place(min, digits) + "  to  " + show_place(max, digits));
    line("size", show_place(size));
  }
  line("area", show_length(report.area));
  line("mean edge", show_length(report.mean_edge));
  line("edges", grouped(report.edges.total) + ", of them " + grouped(report.edges.boundary) +
                    " boundary and " + grouped(report.edges.non_manifold) + " non-manifold");
  line("watertight", show_watertight(report));
  line("volume", show_volume(report));
  line("parts", grouped(report.parts));
  const BadFaces& bad = report.bad_faces;
  line("bad faces", bad.total() == 0
                        ? "none"
                        : grouped(bad.degenerate) + " repeat a corner, " + grouped(bad.non_finite) +
                              " are not finite, " + grouped(bad.out_of_range) +
                              " name a vertex that does not exist");
  if (report.zero_area > 0) line("zero area", grouped(report.zero_area) + " faces");
  for (const std::string& attribute : report.attributes) line("also", attribute);
  line.notes(report.notes);
}

void show(const ProgressiveInfo& report, std::ostream& out) {
  const Lines line(out, 12);
  line("format", report.format + ", " + human_bytes(report.bytes));
  line("faces", grouped(report.base_faces) + " to " + grouped(report.faces));
  line("vertices", grouped(report.base_vertices) + " to " + grouped(report.vertices));
  const auto& [min, max] = std::pair{report.box_min, report.box_max};
  std::array<double, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = max[axis] - min[axis];
  const int digits = digits_for({min, max}, *std::max_element(size.begin(), size.end()));
  line("box", show_place(min, digits) + "  to  " + show_place(max, digits));
  line("size", show_place(size));
  line("cost", facts_of(report.cost).name);
  line("positions", report.positions);
  for (const std::string& attribute : report.attributes) line("also", attribute);
  for (const ProgressiveInfo::Prefix& prefix : report.prefixes) {
    line("bytes", grouped(prefix.bytes) + " for " + grouped(prefix.faces) + " faces" +
                      (prefix.error && *prefix.error > 0
                           ? ", within an error of " + show_length(*prefix.error)
                           : ""));
  }
  line.notes(report.notes);
}

// Tells of one file, or shows it.
template <typename Report>
Json told(const Report& report, const InfoArguments& arguments, bool single, bool first) {
  if (!arguments.common.json && !arguments.common.quiet) {
    if (!single) std::cout << (first ? "" : "\n") << clean(report.name) << "\n";
    show(report, std::cout);
  }
  return json_of_report(report);
}

Json tell_of(const std::string& input, Context& context, const InfoArguments& arguments,
             Format from, bool single, bool first) {
  std::variant<InfoReport, ProgressiveInfo> report;
  {
    const ProgressBar bar(context, arguments.common);
    report = info_of_any(context, input, from);
  }
  return std::visit([&](const auto& known) { return told(known, arguments, single, first); },
                    report);
}

// One after the other. A file that cannot be read does not keep the others from being looked at.
void run_info(const InfoArguments& arguments) {
  const std::vector<std::string>& inputs = arguments.inputs;
  if (std::count(inputs.begin(), inputs.end(), "-") > 1)
    throw Error(ErrorKind::usage, "only one of the inputs can be standard input");
  ConvertOptions options;
  arguments.options.read(options);
  Context context;
  prepare(context, arguments.common, "-");
  const bool single = inputs.size() == 1;
  Json reports = Json::array();
  int code = 0;
  for (const std::string& input : inputs) {
    Json json;
    try {
      json = tell_of(input, context, arguments, options.from, single, &input == inputs.data());
    } catch (const Error& error) {
      if (single || error.kind() == ErrorKind::cancelled) throw;
      std::cout.flush();
      tell_error(error.what());
      json = json_of_error(error.what(), error.kind());
      json["file"] = input;
      if (code == 0) code = error.exit_code();
    }
    reports.push_back(report_of(*arguments.common.owner, json));
  }
  if (arguments.common.json) std::cout << text_of(single ? reports.front() : reports) << "\n";
  if (code != 0) throw Ended{code};
}

}  // namespace

void add_info(CLI::App& app) {
  auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command = app.add_subcommand("info", "Tell what is in a mesh file of any size");
  command->add_option("input", arguments->inputs, input_help() + "; several are told of one by one")
      ->required()
      ->type_name("IN");
  arguments->options.add_to(*command, {"from"});
  arguments->common.add_to(*command, "TMPDIR, or /var/tmp");
  command->footer(
      "Examples:\n"
      "  winnow info scan.ply\n"
      "  winnow info scan.stl --json\n"
      "  winnow info part-*.ply\n"
      "  zstdcat scan.ply.zst | winnow info - --memory 2G");
  command->callback([arguments] { run_info(*arguments); });
}

}  // namespace winnow::cli
