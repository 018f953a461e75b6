#include "base/morton.hpp"
#include "options/level_targets.hpp"
#include "options/option_kinds.hpp"
#include "options/refuse_targets.hpp"
#include "options/shared_entries.hpp"
#include "options/target_kind.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winnow {

namespace {

using Options = SimplifyOptions;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The same with commas between several, in any order: the finest is the target, the others follow.
OptionValue<Options> several(const OptionValue<Options>& one) {
  OptionValue<Options> value;
  value.set = [set = one.set](Options& options, const std::string& text,
                              const std::string& option) {
    std::vector<Target> targets;
    std::size_t begin = 0;
    for (std::size_t comma = 0; comma != std::string::npos; begin = comma + 1) {
      comma = text.find(',', begin);
      Options read = options;
      set(read, text.substr(begin, comma - begin), option);
      targets.push_back(read.target);
    }
    std::stable_sort(targets.begin(), targets.end(), is_finer);
    options.target = targets.front();
    options.coarser.assign(targets.begin() + 1, targets.end());
  };
  value.get = [get = one.get](const Options& options) {
    std::string text = get(options);
    if (text.empty()) return text;
    for (const Target& target : options.coarser) text += "," + text_of(target);
    return text;
  };
  return value;
}

// A number above 1; "full" is infinity.
OptionValue<Options> detail() {
  OptionValue<Options> value =
      number<Options>(&Options::detail, "a number like 6, or full",
                      {1, infinity, true, false, "a number above 1, or full"});
  value.set = [set = value.set](Options& options, const std::string& text,
                                const std::string& option) {
    if (text == "full") {
      options.detail = infinity;
    } else {
      set(options, text, option);
    }
  };
  value.get = [get = value.get](const Options& options) {
    return options.detail && std::isinf(*options.detail) && *options.detail > 0 ? "full"
                                                                                : get(options);
  };
  return value;
}

std::vector<Option<Options>> table() {
  const char* const fineness = "How fine (exactly one)";
  const char* const refinement = "Refinement: edges collapsed after clustering";
  std::vector<Option<Options>> options{
      {"faces", "N", fineness,
       "Stop at this many faces: 500k, 1.5M (only about that many with `refine` none). 1M,100k,10k "
       "writes three files in one run, named by {faces} in OUT.",
       several(target<Options, std::uint64_t>(
           &Target::faces, &Target::faces,
           [](const std::string& text, const std::string& option) {
             return count_in(text, option, 4, std::uint64_t{1} << 62, "at least 4");
           }))},
      {"ratio", "R", fineness,
       "Keep this part of the faces: 0.01 or 1%; several, as 10%,1%, with {ratio} in OUT",
       several(target<Options, double>(&Target::ratio, &Target::ratio,
                                       [](const std::string& text, const std::string& option) {
                                         return ratio_in(text, option, ratio_range);
                                       }))},
      {"cell", "LENGTH", fineness,
       "Size of a grid cell in model units; the only choice that reads a pipe just once",
       target<Options, double>(&Target::cell, &Target::cell,
                               [](const std::string& text, const std::string& option) {
                                 return number_in(
                                     text, option,
                                     "a length like 2.5, a bare number in the units of the "
                                     "model",
                                     length_range);
                               })},
      {"grid", "N", fineness, "Number of grid cells along the longest side",
       target<Options, std::uint64_t>(&Target::grid, &Target::grid,
                                      [](const std::string& text, const std::string& option) {
                                        return count_in(text, option, 1, axis_cells,
                                                        "1 to 2,097,152 cells");
                                      })},
      {"error", "E", fineness,
       "Stop at this error: 0.5 (model units) or 0.1% (of the diagonal). It is the RMS distance; "
       "boundaries stay within 1.5 times it. Several, as 0.1%,1%, with {error} in OUT.",
       several(target<Options, Distance>(&Target::error, &Target::error,
                                         [](const std::string& text, const std::string& option) {
                                           return distance_in(text, option, length_range,
                                                              part_range);
                                         }))},

      {"refine", "COST", refinement,
       "What an edge costs to collapse (default: quadric with `faces`, `ratio` and `error`, else "
       "none)",
       choice<Options>(&Options::refine, words_of<Refine>())},
      {"detail", "D", refinement,
       "Cluster to D times the target first (default 6); 'full' skips clustering", detail()},
      boundary_option<Options>(
          refinement,
          "Open boundaries: 'weigh' moves them at a cost (default), 'keep' fixes their vertices"),
      topology_option<Options>(
          refinement,
          "Handles and holes: 'keep' them, even if the count is missed (default), or be 'free' to "
          "close them and meet it"),
      {"keep_pieces", "", refinement,
       "Keep every connected piece, and refine all faces; by default small ones are removed where "
       "that costs least",
       flag<Options>(&Options::keep_pieces)},
      {"max_normal_deviation", "ANGLE", refinement,
       "Let one collapse turn a face by at most this many degrees (default 45)",
       number<Options>(&Options::max_normal_deviation, "an angle like 60, in degrees",
                       {0, 90, true, false, "an angle above 0 and at most 90 degrees"})},
      {"fit", "N", refinement,
       "Move the vertices N times to where the result is nearest to the original (default 0)",
       count<Options>(&Options::fit, 0, 100, "0 to 100 passes")},

      strict_option<Options>(),
      crop_option<Options>(),
      weld_option<Options>(),
      from_option<Options>(&Options::from),

      {"placement", "HOW", result_group,
       "Where a vertex goes in its cell: 'quadric' is closest to the surface and keeps "
       "boundaries in place (default), 'mean' is nearly twice as fast",
       choice<Options>(&Options::placement,
                       std::vector<std::pair<const char*, Placement>>{
                           {"mean", Placement::mean}, {"quadric", Placement::quadric}})},
      {"normals", "", result_group,
       "Write vertex normals computed from the result instead of the input's",
       flag<Options>(&Options::normals)},
      {"attributes", "LIST", result_group,
       "Vertex attributes to carry: auto (default: all numbers that the output can hold), none, or "
       "a list such as normals,colors,quality",
       attribute_list<Options>()},
      {"nodata", "VALUE", result_group,
       "Leave this number out of means: it says that there is no value",
       number<Options>(&Options::nodata, "a number like -9999")},
      {"map", "FILE", result_group,
       "Write where each vertex of the input went: a NumPy array of int64, numbers of vertices of "
       "the output, -1 for none; of several results one each, with {faces}, {ratio} or {error} in "
       "FILE",
       text<Options>(&Options::map)}};
  add_output_options(options);
  return options;
}

}  // namespace

std::span<const Option<SimplifyOptions>> simplify_options() {
  static const std::vector<Option<Options>> options = table();
  return options;
}

}  // namespace winnow
