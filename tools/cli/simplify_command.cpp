#include <winnow/checkpoint.hpp>
#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "json_text.hpp"
#include "numbers.hpp"
#include "program.hpp"

#include <array>
#include <iostream>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace winnow::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
  std::vector<std::string> inputs;
  std::string output, crop;
  std::string cell, grid, faces, ratio, error;
  std::string placement = "quadric", refine, detail, boundary = "weigh", max_normal_deviation;
  std::string attributes = "auto";
  std::string from;
  std::string checkpoint;
  bool keep_checkpoint = false;
  bool normals = false, strict = false, dry_run = false;
  OutputOptions written;
  CommonOptions common;
};

constexpr std::array<std::pair<const char*, Refine>, 4> refine_names{{{"none", Refine::none},
                                                                      {"quadric", Refine::quadric},
                                                                      {"volume", Refine::volume},
                                                                      {"importance", Refine::importance}}};

Refine refine_called(const std::string& name) {
  for (const auto& [word, refine] : refine_names) {
    if (name == word) return refine;
  }
  return Refine::none;
}

const char* name_of(Refine refine) {
  for (const auto& [word, value] : refine_names) {
    if (refine == value) return word;
  }
  return "";
}

SimplifyOptions options_of(const Arguments& arguments) {
  SimplifyOptions options;
  if (!arguments.cell.empty()) options.cell = parse_length("--cell", arguments.cell);
  if (!arguments.grid.empty()) options.grid = parse_count("--grid", arguments.grid);
  if (!arguments.faces.empty()) options.faces = parse_count("--faces", arguments.faces);
  if (!arguments.ratio.empty()) options.ratio = parse_ratio("--ratio", arguments.ratio);
  if (arguments.error.ends_with('%')) {
    options.relative_error = parse_ratio("--error", arguments.error);
  } else if (!arguments.error.empty()) {
    options.error = parse_length("--error", arguments.error);
  }
  if (!arguments.refine.empty()) options.refine = refine_called(arguments.refine);
  if (arguments.detail == "full") {
    options.detail = std::numeric_limits<double>::infinity();
  } else if (!arguments.detail.empty()) {
    options.detail = parse_number("--detail", arguments.detail, "a number like 6, or full");
  }
  if (arguments.boundary == "keep") options.borders = Borders::keep;
  if (!arguments.max_normal_deviation.empty())
    options.max_normal_deviation = parse_number("--max-normal-deviation", arguments.max_normal_deviation,
                                                "an angle like 60, in degrees");
  options.placement = arguments.placement == "mean" ? Placement::mean : Placement::quadric;
  if (!arguments.crop.empty()) options.crop = parse_box("--crop", arguments.crop);
  options.normals = arguments.normals;
  if (arguments.attributes == "none") {
    options.attributes.emplace();
  } else if (arguments.attributes != "auto") {
    options.attributes = CLI::detail::split(arguments.attributes, ',');
  }
  options.strict = arguments.strict;
  options.force = arguments.written.force;
  options.from = parse_input_format(arguments.from);
  options.to = parse_output_format(arguments.written.to);
  options.encoding = arguments.written.encoding();
  return options;
}

Json json_of(const std::optional<Resumed>& resumed) {
  if (!resumed) return nullptr;
  return {{"clustered", resumed->clustered},
          {"rounds", resumed->rounds},
          {"tiles", resumed->tiles},
          {"written", resumed->written}};
}

Json json_of(const SimplifyReport& report) {
  const BadFaces& bad = report.input.bad_faces;
  return {
      {"input",
       {{"faces", report.input.faces},
        {"vertices", report.input.vertices},
        {"bytes", report.input.bytes},
        {"cropped_faces", report.input.cropped_faces},
        {"bad_faces",
         {{"degenerate", bad.degenerate},
          {"non_finite", bad.non_finite},
          {"out_of_range", bad.out_of_range}}}}},
      {"output",
       {{"faces", report.output.faces},
        {"vertices", report.output.vertices},
        {"bytes", report.output.bytes}}},
      {"target", {{"faces", report.target_faces ? Json(*report.target_faces) : Json(nullptr)}}},
      {"refine",
       {{"cost", name_of(report.refine.cost)},
        {"tiles", report.refine.tiles},
        {"collapses", report.refine.collapses},
        {"max_error", report.refine.max_error},
        {"stopped_by", report.refine.stopped_by.empty() ? Json(nullptr) : Json(report.refine.stopped_by)}}},
      {"attributes",
       {{"carried", report.attributes.carried},
        {"dropped", report.attributes.dropped},
        {"ignored_values", report.attributes.ignored}}},
      {"cell_size", report.cell_size},
      {"cells", report.cells},
      {"turned_faces", report.turned_faces},
      {"fused_faces", report.fused_faces},
      {"clamped_faces", report.clamped_faces},
      {"error_bound", report.error_bound},
      {"runs", report.runs},
      {"spilled_bytes", report.spilled_bytes},
      {"peak_scratch_bytes", report.peak_scratch_bytes},
      {"peak_memory_bytes", report.peak_memory_bytes},
      {"seconds",
       {{"total", report.seconds.total},
        {"read", report.seconds.read},
        {"cluster", report.seconds.cluster},
        {"refine", report.seconds.refine},
        {"write", report.seconds.write}}},
      {"resumed", json_of(report.resumed)},
      {"notes", report.notes}};
}

// What had been done before.
std::string describe(const Resumed& resumed) {
  if (resumed.written) return "all was done";
  if (!resumed.clustered) return "nothing was done yet";
  std::string text = "the input was read";
  if (resumed.rounds > 0)
    text += ", " + show_count(resumed.rounds) + (resumed.rounds == 1 ? " round" : " rounds") + " refined";
  if (resumed.tiles > 0)
    text +=
        ", " + show_count(resumed.tiles) + (resumed.tiles == 1 ? " tile" : " tiles") + " of the next tried";
  return text;
}

std::string percent(double part) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(),
                part < 0.001 ? "%.4f %%"
                : part < 0.1 ? "%.2f %%"
                             : "%.1f %%",
                part * 100);
  return text.data();
}

void show(const SimplifyReport& report, std::ostream& out) {
  const auto line = [&](const char* name, const std::string& text) {
    out << "  " << name << std::string(10 - std::min<std::size_t>(9, std::string_view(name).size()), ' ')
        << text << "\n";
  };
  const double part = report.input.faces == 0 ? 0
                                              : static_cast<double>(report.output.faces) /
                                                    static_cast<double>(report.input.faces);
  line("faces", show_count(report.input.faces) + " -> " + show_count(report.output.faces) + "  (" +
                    percent(part) + ")");
  std::string vertices = show_count(report.output.vertices);
  if (report.input.vertices > 0) vertices = show_count(report.input.vertices) + " -> " + vertices;
  line("vertices", vertices);
  line("file", show_bytes(report.input.bytes) + " -> " + show_bytes(report.output.bytes));
  const bool refined = report.refine.cost != Refine::none;
  if (report.cell_size > 0) {
    line("cell", show_length(report.cell_size) +
                     (refined ? "  (clustered first)"
                              : "  (no vertex is farther than " + show_length(report.error_bound) +
                                    " from the surface)"));
  }
  if (refined) {
    line("refined", show_count(report.refine.collapses) + " edges collapsed by " +
                        name_of(report.refine.cost) + ", " + show_count(report.refine.tiles) +
                        (report.refine.tiles == 1 ? " tile" : " tiles"));
  }
  if (!report.attributes.carried.empty()) line("carried", show_list(report.attributes.carried));
  if (report.resumed) line("resumed", describe(*report.resumed));
  line("time", show_seconds(report.seconds.total) + "  (" +
                   show_rate(static_cast<double>(report.input.faces) / report.seconds.total) + "faces/s)");
  std::string memory = show_bytes(report.peak_memory_bytes) + " at its peak";
  if (report.peak_scratch_bytes > 0)
    memory += ", and " + show_bytes(report.peak_scratch_bytes) + " of scratch";
  line("memory", memory);
  const BadFaces& bad = report.input.bad_faces;
  if (bad.total() > 0) line("bad faces", show_bad_faces(bad));
  if (report.input.cropped_faces > 0)
    line("cropped", show_count(report.input.cropped_faces) + " faces, not wholly inside of the box");
  if (report.clamped_faces > 0)
    line("weights",
         show_count(report.clamped_faces) + " faces span so many cells that their weight was limited");
  for (const std::string& note : report.notes) line("note", note);
}

Json json_of(const SimplifyPlan& plan) {
  const auto optional = [](const auto& value) { return value ? Json(*value) : Json(nullptr); };
  Json memory = Json::object();
  for (const SimplifyPlan::Part& part : plan.memory) memory[part.name] = part.bytes;
  return {{"memory", memory},
          {"smallest_memory", plan.smallest_memory},
          {"passes", plan.passes},
          {"faces", optional(plan.faces)},
          {"vertices", optional(plan.vertices)},
          {"scratch_worst", optional(plan.scratch_worst)},
          {"scratch_expected", optional(plan.scratch_expected)},
          {"seconds_expected", optional(plan.seconds_expected)}};
}

void show(const SimplifyPlan& plan, std::ostream& out) {
  out << "input\n  faces     " << (plan.faces ? show_count(*plan.faces) : "not known before it is read")
      << "\n";
  if (plan.vertices) out << "  vertices  " << show_count(*plan.vertices) << "\n";
  out << "passes\n";
  for (std::size_t i = 0; i < plan.passes.size(); ++i) out << "  " << i + 1 << ". " << plan.passes[i] << "\n";
  out << "memory\n";
  for (const SimplifyPlan::Part& part : plan.memory) {
    const std::string size = show_bytes(part.bytes);
    out << "  " << std::string(10 - std::min<std::size_t>(9, size.size()), ' ') << size << "  " << part.name
        << "\n";
  }
  out << "  the smallest budget that works: " << show_bytes(plan.smallest_memory) << "\n";
  if (plan.scratch_worst) {
    out << "scratch\n  about " << show_bytes(*plan.scratch_expected)
        << " for a coherent scan at a tenth of its faces, never more than " << show_bytes(*plan.scratch_worst)
        << "\n";
  }
  if (plan.seconds_expected)
    out << "time\n  about " << show_seconds(*plan.seconds_expected) << " where the disk keeps up\n";
}

void run(const Arguments& arguments) {
  const SimplifyOptions options = options_of(arguments);
  Context context;
  prepare(context, arguments.common, arguments.output);
  if (arguments.dry_run) {
    const SimplifyPlan plan = plan_simplify(context, arguments.inputs, arguments.output, options);
    if (arguments.common.json) {
      std::cout << text_of(json_of(plan)) << "\n";
    } else {
      show(plan, std::cout);
    }
    return;
  }
  SimplifyReport report;
  {
    const ProgressBar bar(context, arguments.common);
    if (arguments.checkpoint.empty()) {
      report = simplify(context, arguments.inputs, arguments.output, options);
    } else {
      if (arguments.common.scratch.empty()) context.scratch.clear();  // that is the checkpoint's directory
      report = simplify(context, arguments.inputs, arguments.output, options,
                        {arguments.checkpoint, arguments.keep_checkpoint});
    }
  }
  tell(report, arguments.common);
}

}  // namespace

void tell(const SimplifyReport& report, const CommonOptions& options) {
  std::ostream& out = report_stream(report.output.name);
  if (options.json) {
    out << text_of(json_of(report)) << "\n";
  } else if (!options.quiet) {
    show(report, out);
  }
}

void add_simplify(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("simplify", "Make a mesh of any size small, in bounded memory");
  command->add_option("input", arguments->inputs, std::string(input_names) + "; several files are one model")
      ->required()
      ->type_name("IN");
  command->add_option("-o,--output", arguments->output, output_help)->required()->type_name("OUT");

  const std::string fineness = "How fine (exactly one)";
  command
      ->add_option("--faces", arguments->faces,
                   "So many faces: 500k, 1.5M (about so many without refinement)")
      ->type_name("N")
      ->group(fineness);
  command->add_option("--ratio", arguments->ratio, "This part of the faces: 0.01 or 1%")
      ->type_name("R")
      ->group(fineness);
  command
      ->add_option("--cell", arguments->cell,
                   "Edge of a grid cell in model units; the only one that reads a pipe just once")
      ->type_name("LENGTH")
      ->group(fineness);
  command->add_option("--grid", arguments->grid, "Grid cells along the longest side")
      ->type_name("N")
      ->group(fineness);

  command
      ->add_option(
          "--error", arguments->error,
          "As few faces as keep vertices so near to what they stand for: 0.5 (model units) or 0.1% of the "
          "diagonal")
      ->type_name("E")
      ->group(fineness);

  const std::string refinement = "Refinement: edges collapsed after clustering";
  command
      ->add_option(
          "--refine", arguments->refine,
          "By the cost quadric (default with --faces, --ratio, --error), volume, importance, or none")
      ->check(CLI::IsMember({"none", "quadric", "volume", "importance"}))
      ->type_name("COST")
      ->group(refinement);
  command
      ->add_option("--detail", arguments->detail,
                   "Faces that clustering leaves for each that is wanted (default 6), or full: no clustering")
      ->type_name("D")
      ->group(refinement);
  command
      ->add_option("--boundary", arguments->boundary,
                   "Open borders: weigh (default: they resist being moved) or keep (their vertices stay)")
      ->check(CLI::IsMember({"weigh", "keep"}))
      ->type_name("HOW")
      ->group(refinement);
  command
      ->add_option("--max-normal-deviation", arguments->max_normal_deviation,
                   "By how many degrees one collapse may turn a face (default 45)")
      ->type_name("ANGLE")
      ->group(refinement);

  const std::string result = "What the result is";
  command
      ->add_option("--placement", arguments->placement,
                   "Where in its cell a vertex goes: quadric (default, the closest to the surface) or mean "
                   "(a quarter faster)")
      ->check(CLI::IsMember({"mean", "quadric"}))
      ->type_name("HOW")
      ->group(result);
  command
      ->add_flag("--normals", arguments->normals,
                 "Write vertex normals computed from the result, instead of those of the input")
      ->group(result);
  command
      ->add_option(
          "--attributes", arguments->attributes,
          "What vertices carry along: auto (default: all numbers that have a mean and the output can hold), "
          "none, or a list: normals,colors,quality")
      ->type_name("LIST")
      ->group(result);
  command
      ->add_flag("--strict", arguments->strict, "The first bad face is an error, not a number in the report")
      ->group(result);
  command
      ->add_option("--crop", arguments->crop,
                   "Only faces that lie wholly in this box, in model units: xmin,ymin,zmin,xmax,ymax,zmax")
      ->type_name("BOX")
      ->group(result);
  command
      ->add_option("--from", arguments->from,
                   std::string("Input format, where the content does not tell: ") + input_formats)
      ->type_name("FORMAT")
      ->group(result);
  arguments->written.add_to(*command, result);
  const std::string killed = "Long runs";
  command
      ->add_option(
          "--checkpoint", arguments->checkpoint,
          "A new or empty directory, for scratch too; 'winnow resume DIR' goes on if the run is killed")
      ->type_name("DIR")
      ->group(killed);
  command
      ->add_flag("--keep-checkpoint", arguments->keep_checkpoint,
                 "Leave the files in DIR when the run is done (default: they are removed)")
      ->group(killed);
  command->add_flag("--dry-run", arguments->dry_run, "Show passes, memory and scratch; do nothing")
      ->group("Messages");
  arguments->common.add_to(*command, true);
  command->footer(
      "Examples:\n"
      "  winnow simplify scan.ply -o small.ply --faces 500k\n"
      "  winnow simplify scan.ply -o small.ply --ratio 1% --memory 256M\n"
      "  winnow simplify scan.ply -o small.ply --error 0.1%\n"
      "  winnow simplify scan.ply -o small.ply --faces 1M --detail full\n"
      "  winnow simplify scan.stl -o small.ply --faces 1M --refine none\n"
      "  winnow simplify scan.ply -o small.ply --faces 100M --checkpoint kept    # if killed: winnow resume "
      "kept\n"
      "  winnow simplify part-*.ply -o all.ply --faces 5M --crop 0,0,-10,500,500,90\n"
      "  zstdcat scan.ply.zst | winnow simplify - -o - --cell 2.5 | next-stage\n"
      "\nExit codes: 0 done, 1 failed otherwise, 2 usage, 3 bad input, 4 memory or disk, 130 interrupted.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace winnow::cli
