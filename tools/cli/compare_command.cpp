#include <winnow/error.hpp>
#include <winnow/options.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_json.hpp"
#include "report_text.hpp"

#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

namespace winnow::cli {

namespace {

struct CompareArguments {
  std::string original, simplified;
  TableOptions<CompareOptions> options{compare_options()};
  CommonOptions common;
};

std::string fixed(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

void show(const CompareReport& report, std::ostream& out) {
  const Lines line(out, 14);
  const auto distances = [&](const char* name, const Distances& d) {
    const auto one = [&](double length) {
      std::array<char, 64> text{};
      std::snprintf(text.data(), text.size(), "%12s %8.4f %%", show_length(length).c_str(),
                    percent_of(report.diagonal, length));
      return std::string(text.data());
    };
    line(name, one(d.mean) + one(d.rms) + one(d.max));
  };
  line("faces", grouped(report.original.faces) + " -> " + grouped(report.simplified.faces) + "  (" +
                    fixed(100 * static_cast<double>(report.simplified.faces) /
                              static_cast<double>(report.original.faces),
                          2) +
                    " %)");
  line("distance", "        mean of diagonal          rms of diagonal          max of diagonal");
  distances("  forward", report.forward);
  distances("  backward", report.backward);
  distances("  symmetric", report.symmetric);
  line("  worst at", show_place(report.worst, digits_for({report.worst}, report.diagonal)));
  line("normals", "differ by " + fixed(report.normal_deviation.mean, 2) +
                      " degrees in the mean, 95 of 100 by up to " +
                      fixed(report.normal_deviation.p95, 2));
  const auto change = [](double part) {
    return (part < 0 ? "" : "+") + fixed(100 * part, 3) + " %";
  };
  line("area", change(report.area_change));
  line("volume",
       report.volume_change ? change(*report.volume_change) : "not compared: not both are closed");
  const auto& t = report.topology;
  line("edges",
       grouped(t.boundary_edges) + " boundary, " + grouped(t.non_manifold_edges) + " non-manifold");
  line("faces", grouped(t.flipped) + " flipped, " + grouped(t.degenerate) + " degenerate, " +
                    grouped(t.duplicate) + " duplicate");
  line("components", grouped(t.components));
  line("angles", "smallest of each face: " + fixed(report.smallest_angles.mean, 1) +
                     " degrees in the mean, " + fixed(report.smallest_angles.min, 2) +
                     " at least, " + fixed(100 * report.smallest_angles.below_10, 2) +
                     " % of the faces below 10");
  const std::uint64_t bad = report.original.bad_faces.total() + report.simplified.bad_faces.total();
  if (bad > 0) {
    line("left out", grouped(report.original.bad_faces.total()) + " bad faces of the original, " +
                         grouped(report.simplified.bad_faces.total()) + " of the simplified mesh");
  }
  line("time",
       show_seconds(report.seconds) + ", peak memory " + human_bytes(report.peak_memory_bytes));
  line.notes(report.notes);
}

std::string show(const Distance& distance) {
  return distance.relative ? show_length(100 * distance.value) + " %" : show_length(distance.value);
}

void run_compare(const CompareArguments& arguments) {
  CompareOptions options;
  arguments.options.read(options);
  if (arguments.options.given("view") && options.picture.empty())
    throw Error(ErrorKind::usage, "`view` goes with `picture`");
  Context context;
  prepare(context, arguments.common, options.colored.empty() ? "-" : options.colored);
  const CompareReport report = with_progress(context, arguments.common, [&] {
    return compare(context, arguments.original, arguments.simplified, options);
  });
  const bool mesh_on_output = options.colored == "-" || options.picture == "-";
  std::ostream& out = report_stream(mesh_on_output ? "-" : "");
  tell(report, arguments.common, out, show);
  if (!report.limit || !report.limit->exceeded) return;
  out.flush();
  tell_error("the RMS distance of " + show_length(report.symmetric.rms) + " (" +
             show_length(percent_of(report.diagonal, report.symmetric.rms)) +
             " % of the diagonal) is above " + show(*options.fail_above));
  throw Ended{static_cast<int>(ErrorKind::failed)};
}

}  // namespace

void add_compare(CLI::App& app) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command =
      app.add_subcommand("compare", "Measure how far a simplified mesh is from its original");
  command
      ->add_option("original", arguments->original,
                   "The original mesh, of any size: it is streamed; - is standard input")
      ->required()
      ->type_name("ORIGINAL");
  command
      ->add_option("simplified", arguments->simplified,
                   "The simplified mesh; it must fit into --memory, with 400 bytes a face")
      ->required()
      ->type_name("SIMPLIFIED");
  arguments->options.add_to(*command);
  arguments->common.add_to(*command, "TMPDIR, or /var/tmp");
  command->footer(
      "A distance is that of a point on one surface to the nearest point of the other: forward "
      "from the\n"
      "original to the simplified mesh, backward the other way.\n"
      "In the picture y is up, or z for a mesh that is flat in z.\n"
      "Above --fail-above the exit code is 1.\n"
      "Examples:\n"
      "  winnow compare scan.ply small.ply\n"
      "  winnow compare scan.ply small.ply --json --samples 10M\n"
      "  winnow compare scan.ply small.ply --fail-above 0.1% --quiet || echo too coarse\n"
      "  winnow compare scan.ply small.ply --colored distances.ply --picture distances.png\n"
      "  winnow compare scan.ply small.ply --picture below.png --view 1,-1,-0.5");
  command->callback([arguments] { run_compare(*arguments); });
}

}  // namespace winnow::cli
