#include "simplify_report.hpp"

#include <winnow/checkpoint.hpp>
#include <winnow/simplify.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_json.hpp"
#include "report_text.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <string>
#include <utility>

namespace winnow::cli {

namespace {

std::string percent(double part) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(),
                part < 0.001 ? "%.4f %%"
                : part < 0.1 ? "%.2f %%"
                             : "%.1f %%",
                part * 100);
  return text.data();
}

std::string describe(const SurfaceEdges& edges) {
  return grouped(edges.boundary) + " boundary and " + grouped(edges.non_manifold) + " non-manifold";
}

void show(const SimplifyReport& report, std::ostream& out) {
  const Lines line(out, 10);
  const double part = report.input.faces == 0 ? 0
                                              : static_cast<double>(report.output.faces) /
                                                    static_cast<double>(report.input.faces);
  line("faces", grouped(report.input.faces) + " -> " + grouped(report.output.faces) + "  (" +
                    percent(part) + ")");
  std::string vertices = grouped(report.output.vertices);
  if (report.input.vertices > 0) vertices = grouped(report.input.vertices) + " -> " + vertices;
  line("vertices", vertices);
  line("file", human_bytes(report.input.bytes) + " -> " + human_bytes(report.output.bytes));
  for (const LevelReport& level : report.levels) {
    line("level", grouped(level.output.faces) + " faces, " + grouped(level.output.vertices) +
                      " vertices, " + human_bytes(level.output.bytes) + ": " + level.output.name);
    if (!level.output.map.empty()) line("map", level.output.map);
  }
  if (report.levels.empty() && !report.output.map.empty()) line("map", report.output.map);
  show_quantized(line, report.output.position_error);
  if (report.weld.distance > 0) {
    line("welded", grouped(report.weld.vertices) + " vertices nearer than " +
                       show_length(report.weld.distance) + " to another; " +
                       grouped(report.weld.faces) + " faces collapsed");
  }
  const bool refined = report.refine.cost != Refine::none;
  if (report.cell_size > 0) {
    const std::string split = report.split_cells == 0 ? ""
                                                      : ", " + grouped(report.split_cells) +
                                                            " cells split to keep the surface";
    line("cell", show_length(report.cell_size) +
                     (refined ? "  (clustered first" + split + ")"
                              : "  (no vertex is farther than " + show_length(report.error_bound) +
                                    " from the surface)"));
  }
  if (!report.clustered.reason.empty())
    line("clustered", std::string(!report.clustered.first ? "no: "
                                  : refined               ? "first: "
                                                          : "only: ") +
                          report.clustered.reason);
  if (refined) {
    line("refined", grouped(report.refine.collapses) + " edges collapsed by " +
                        facts_of(report.refine.cost).name + ", " + grouped(report.refine.tiles) +
                        (report.refine.tiles == 1 ? " tile" : " tiles"));
  }
  if (report.fit.passes > 0) {
    line("fitted", "RMS of " + grouped(report.fit.samples) + " samples " +
                       show_length(report.fit.rms_before) + " -> " +
                       show_length(report.fit.rms_after) +
                       (report.fit.passes == 1 ? ", one pass"
                                               : ", " + grouped(report.fit.passes) + " passes"));
  }
  if (report.topology.output.total > 0) {
    std::string edges = describe(report.topology.output);
    if (report.topology.input) edges = describe(*report.topology.input) + " -> " + edges;
    edges += report.topology.closed ? "  (closed" : "  (not closed";
    if (!report.topology.input) edges += "; 'winnow info' counts those of the input";
    line("edges", edges + ")");
    if (report.topology.output_pieces) {
      std::string pieces = grouped(*report.topology.output_pieces);
      if (report.topology.input_pieces)
        pieces = grouped(*report.topology.input_pieces) + " -> " + pieces;
      line("pieces", pieces);
    }
    line("area", show_length(report.area.input) + " -> " + show_length(report.area.output));
  }
  if (const std::string lost = show_lost(report.lost); !lost.empty()) line("lost", lost);
  if (!report.attributes.carried.empty()) line("carried", show_list(report.attributes.carried));
  if (report.resumed) line("resumed", show_resumed(*report.resumed));
  line("time", show_time(report.seconds.total, report.input.faces));
  line("memory", show_memory(report.peak_memory_bytes, report.peak_scratch_bytes));
  const BadFaces& bad = report.input.bad_faces;
  if (bad.total() > 0) line("bad faces", show_bad_faces(bad));
  if (report.input.cropped_faces > 0)
    line("cropped", grouped(report.input.cropped_faces) + " faces, not wholly inside of the box");
  if (report.weight_clamped_faces > 0)
    line("weights", grouped(report.weight_clamped_faces) +
                        " faces span so many cells that their weight was limited");
  line.notes(report.notes);
}

void show(const SimplifyPlan& plan, std::ostream& out) {
  out << "input\n  faces     "
      << (plan.faces ? grouped(*plan.faces) : "not known before it is read") << "\n";
  if (plan.vertices) out << "  vertices  " << grouped(*plan.vertices) << "\n";
  out << "passes\n";
  for (std::size_t i = 0; i < plan.passes.size(); ++i)
    out << "  " << i + 1 << ". " << plan.passes[i] << "\n";
  out << "clustered\n  "
      << (!plan.clustered   ? ""
          : *plan.clustered ? "yes: "
                            : "no: ")
      << spoken(plan.clustered_reason) << "\n";
  if (plan.outputs.size() > 1) {
    out << "outputs\n";
    for (const std::string& name : plan.outputs) out << "  " << clean(name) << "\n";
  }
  if (!plan.maps.empty()) {
    out << "maps\n";
    for (const std::string& name : plan.maps) out << "  " << clean(name) << "\n";
  }
  out << "memory\n";
  for (const SimplifyPlan::Part& part : plan.memory) {
    const std::string size = human_bytes(part.bytes);
    out << "  " << std::string(10 - std::min<std::size_t>(9, size.size()), ' ') << size << "  "
        << spoken(part.name) << "\n";
  }
  out << "  the smallest budget that works: " << human_bytes(plan.smallest_memory) << "\n";
  if (plan.scratch_worst) {
    out << "scratch\n  ";
    if (plan.scratch_expected)
      out << "about " << human_bytes(*plan.scratch_expected) << " for a coherent scan, ";
    out << "never more than " << human_bytes(*plan.scratch_worst) << "\n";
  }
  if (plan.seconds_expected)
    out << "time\n  about " << show_seconds(*plan.seconds_expected) << " where the disk keeps up\n";
}

}  // namespace

void tell(const SimplifyReport& report, const CommonOptions& options) {
  tell(report, options, report_stream(report.output.name), show);
}

void tell(const SimplifyPlan& plan, const CommonOptions& options) {
  if (options.json) {
    print(json_of_report(plan), options, std::cout);
  } else {
    show(plan, std::cout);
  }
}

}  // namespace winnow::cli
