#include <winnow/checkpoint.hpp>
#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "simplify_report.hpp"
#include "usage_errors.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace winnow::cli {

namespace {

struct SimplifyArguments {
  std::vector<std::string> inputs;
  std::string output, crop, weld;
  std::string cell, grid, faces, ratio, error;
  std::string placement = "quadric", refine, detail, boundary = "weigh", topology = "keep",
              max_normal_deviation;
  std::string attributes = "auto";
  std::string nodata;
  std::string from;
  std::string checkpoint;
  bool keep_checkpoint = false, keep_pieces = false;
  bool normals = false, strict = false, dry_run = false;
  OutputOptions written;
  CommonOptions common;
};

SimplifyOptions options_of(const SimplifyArguments& arguments) {
  SimplifyOptions options;
  if (!arguments.cell.empty()) options.cell = parse_length("--cell", arguments.cell);
  if (!arguments.grid.empty()) options.grid = parse_count("--grid", arguments.grid);
  if (!arguments.faces.empty()) options.faces = parse_count("--faces", arguments.faces);
  if (!arguments.ratio.empty()) options.ratio = parse_ratio("--ratio", arguments.ratio);
  if (!arguments.error.empty()) {
    const Distance error = parse_distance("--error", arguments.error);
    (error.relative ? options.relative_error : options.error) = error.value;
  }
  if (!arguments.refine.empty()) options.refine = refine_called(arguments.refine);
  if (arguments.detail == "full") {
    options.detail = std::numeric_limits<double>::infinity();
  } else if (!arguments.detail.empty()) {
    options.detail = parse_number("--detail", arguments.detail, "a number like 6, or full");
  }
  if (arguments.boundary == "keep") options.borders = Borders::keep;
  if (arguments.topology == "free") options.topology = Topology::free;
  options.keep_pieces = arguments.keep_pieces;
  if (!arguments.max_normal_deviation.empty())
    options.max_normal_deviation = parse_number(
        "--max-normal-deviation", arguments.max_normal_deviation, "an angle like 60, in degrees");
  options.placement = arguments.placement == "mean" ? Placement::mean : Placement::quadric;
  if (!arguments.weld.empty()) {
    const Distance weld = parse_distance("--weld", arguments.weld);
    (weld.relative ? options.relative_weld : options.weld) = weld.value;
  }
  if (!arguments.crop.empty()) options.crop = parse_box("--crop", arguments.crop);
  options.normals = arguments.normals;
  if (arguments.attributes == "none") {
    options.attributes.emplace();
  } else if (arguments.attributes != "auto") {
    options.attributes = CLI::detail::split(arguments.attributes, ',');
    if (std::find(options.attributes->begin(), options.attributes->end(), "") !=
        options.attributes->end())
      throw Error(ErrorKind::usage, "--attributes '" + arguments.attributes +
                                        "' has an empty name; put one comma between two names");
  }
  if (!arguments.nodata.empty())
    options.no_data = parse_number("--nodata", arguments.nodata, "a number like -9999");
  options.strict = arguments.strict;
  options.force = arguments.written.force;
  options.from = format_called(arguments.from);
  options.to = format_called(arguments.written.to);
  options.encoding = arguments.written.encoding();
  return options;
}

void run_simplify(const SimplifyArguments& arguments) {
  const SimplifyOptions options = options_of(arguments);
  Context context;
  prepare(context, arguments.common, arguments.output);
  if (arguments.dry_run) {
    tell(plan_simplify(context, arguments.inputs, arguments.output, options), arguments.inputs,
         arguments.output, arguments.common);
    return;
  }
  SimplifyReport report;
  {
    const ProgressBar bar(context, arguments.common);
    if (arguments.checkpoint.empty()) {
      report = simplify(context, arguments.inputs, arguments.output, options);
    } else {
      if (arguments.common.scratch.empty())
        context.scratch.clear();  // that is the checkpoint's directory
      report = simplify(context, arguments.inputs, arguments.output, options,
                        {arguments.checkpoint, arguments.keep_checkpoint});
    }
  }
  tell(report, arguments.common);
}

}  // namespace

void add_simplify(CLI::App& app) {
  auto arguments = std::make_shared<SimplifyArguments>();
  CLI::App* command =
      app.add_subcommand("simplify", "Make a mesh of any size small, in bounded memory");
  command
      ->add_option("input", arguments->inputs,
                   std::string(input_help) + "; several files are one model")
      ->required()
      ->type_name("IN");
  command->add_option("-o,--output", arguments->output, output_help)->required()->type_name("OUT");

  const std::string fineness = "How fine (exactly one)";
  command
      ->add_option("--faces", arguments->faces,
                   "Stop at this many faces: 500k, 1.5M (only about that many with --refine none)")
      ->type_name("N")
      ->group(fineness);
  command->add_option("--ratio", arguments->ratio, "Keep this part of the faces: 0.01 or 1%")
      ->type_name("R")
      ->group(fineness);
  command
      ->add_option(
          "--cell", arguments->cell,
          "Size of a grid cell in model units; the only choice that reads a pipe just once")
      ->type_name("LENGTH")
      ->group(fineness);
  command->add_option("--grid", arguments->grid, "Number of grid cells along the longest side")
      ->type_name("N")
      ->group(fineness);

  command
      ->add_option("--error", arguments->error,
                   "Stop at this error: 0.5 (model units) or 0.1% (of the diagonal). It is the RMS "
                   "distance; "
                   "boundaries stay within 1.5 times it.")
      ->type_name("E")
      ->group(fineness);

  const std::string refinement = "Refinement: edges collapsed after clustering";
  command
      ->add_option("--refine", arguments->refine,
                   "What an edge costs to collapse (default: quadric with --faces, --ratio and "
                   "--error, else none)")
      ->check(one_of({"none", "quadric", "volume", "importance"}))
      ->type_name("COST")
      ->group(refinement);
  command
      ->add_option("--detail", arguments->detail,
                   "Cluster to D times the target first (default 6); 'full' skips clustering")
      ->type_name("D")
      ->group(refinement);
  command
      ->add_option(
          "--boundary", arguments->boundary,
          "Open borders: 'weigh' moves them at a price (default), 'keep' fixes their vertices")
      ->check(one_of({"weigh", "keep"}))
      ->type_name("HOW")
      ->group(refinement);
  command
      ->add_option(
          "--topology", arguments->topology,
          "Handles and holes: 'keep' them, even if the count is missed (default), or be 'free' "
          "to close them and meet it")
      ->check(one_of({"keep", "free"}))
      ->type_name("HOW")
      ->group(refinement);
  command
      ->add_flag(
          "--keep-pieces", arguments->keep_pieces,
          "Keep every connected piece; by default small ones are removed where that costs least")
      ->group(refinement);
  command
      ->add_option("--max-normal-deviation", arguments->max_normal_deviation,
                   "Let one collapse turn a face by at most this many degrees (default 45)")
      ->type_name("ANGLE")
      ->group(refinement);

  const std::string result = "What the result is";
  command
      ->add_option(
          "--placement", arguments->placement,
          "Where a vertex goes in its cell: 'quadric' is closest to the surface (default), "
          "'mean' is a quarter faster")
      ->check(one_of({"mean", "quadric"}))
      ->type_name("HOW")
      ->group(result);
  command
      ->add_flag("--normals", arguments->normals,
                 "Write vertex normals computed from the result instead of the input's")
      ->group(result);
  command
      ->add_option("--attributes", arguments->attributes,
                   "Vertex attributes to carry: auto (default: all numbers that the output can "
                   "hold), none, or a "
                   "list such as normals,colors,quality")
      ->type_name("LIST")
      ->group(result);
  command
      ->add_option("--nodata", arguments->nodata,
                   "Leave this number out of means: it says that there is no value")
      ->type_name("VALUE")
      ->group(result);
  command
      ->add_flag("--strict", arguments->strict,
                 "Stop at the first bad face; by default bad faces are left out and counted")
      ->group(result);
  command
      ->add_option(
          "--crop", arguments->crop,
          "Keep only faces wholly inside this box (model units): xmin,ymin,zmin,xmax,ymax,zmax")
      ->type_name("BOX")
      ->group(result);
  command
      ->add_option(
          "--weld", arguments->weld,
          "Join vertices closer than this: 0.01 (model units) or 0.001% (of the diagonal). Chains "
          "of such vertices are joined too.")
      ->type_name("DISTANCE")
      ->group(result);
  add_from(*command, arguments->from)->group(result);
  arguments->written.add_to(*command, result);
  const std::string killed = "Long runs";
  command
      ->add_option("--checkpoint", arguments->checkpoint,
                   "Save the run's state in this new or empty directory; if it is killed, 'winnow "
                   "resume DIR' "
                   "goes on")
      ->type_name("DIR")
      ->group(killed);
  command
      ->add_flag("--keep-checkpoint", arguments->keep_checkpoint,
                 "Leave the files in DIR when the run is done (default: they are removed)")
      ->group(killed);
  command
      ->add_flag("--dry-run", arguments->dry_run,
                 "Show passes, memory and scratch, and write nothing")
      ->group("Messages");
  arguments->common.add_to(*command, true);
  command->footer(
      "Examples:\n"
      "  winnow simplify scan.ply -o small.ply --faces 500k\n"
      "  winnow simplify scan.ply -o small.ply --ratio 1% --memory 256M\n"
      "  winnow simplify scan.ply -o small.ply --error 0.1%\n"
      "  winnow simplify scan.ply -o small.ply --faces 1M --detail full\n"
      "  winnow simplify scan.stl -o small.ply --faces 1M --refine none\n"
      "  winnow simplify soup.stl -o small.ply --faces 50k --weld 0.01\n"
      "  winnow simplify bone.ply -o small.ply --ratio 2% --topology free\n"
      "  winnow simplify scan.ply -o small.ply --faces 100M --checkpoint kept\n"
      "  winnow simplify part-*.ply -o all.ply --faces 5M --crop 0,0,-10,500,500,90\n"
      "  zstdcat scan.ply.zst | winnow simplify - -o - --cell 2.5 | next-stage\n"
      "\nExit codes: 0 done, 1 failed otherwise, 2 usage, 3 bad input, 4 memory or disk, 130 "
      "interrupted.");
  command->callback([arguments] { run_simplify(*arguments); });
}

}  // namespace winnow::cli
