// The table of simplify_sequence().
#include "options/option_kinds.hpp"
#include "options/shared_entries.hpp"
#include "options/target_kind.hpp"

#include <limits>

namespace winnow {

std::span<const Option<SequenceOptions>> sequence_options() {
  using Options = SequenceOptions;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr NumberRange weight{0, infinity, false, true, "a number of 0 or more"};
  static constexpr NumberRange ratio_range{0, 1, true, false,
                                           "a part above 0 and at most 1 (or 100%)"};
  const char* const fineness = "How fine (exactly one)";
  const char* const costs = "What stays longer";
  static const std::vector<Option<Options>> options = [=] {
    std::vector<Option<Options>> table{
        {"faces", "N", fineness, "Stop at this many faces in each frame: 5k",
         target<Options, std::uint64_t>(&Target::faces, &Target::faces,
                                        [](const std::string& text, const std::string& option) {
                                          return count_in(text, option, 4, std::uint64_t{1} << 62,
                                                          "at least 4");
                                        })},
        {"ratio", "R", fineness, "Keep this part of the faces: 0.1 or 10%",
         target<Options, double>(&Target::ratio, &Target::ratio,
                                 [](const std::string& text, const std::string& option) {
                                   return ratio_in(text, option, ratio_range);
                                 })},
        {"quadrics", "KIND", costs,
         "Planes that a collapse is measured by: memoryless, of the faces around it then; "
         "accumulated, of all faces of the input that it stands for (default memoryless)",
         choice<Options>(
             &Options::quadrics,
             std::vector<std::pair<const char*, Quadrics>>{
                 {"memoryless", Quadrics::memoryless}, {"accumulated", Quadrics::accumulated}})},
        {"deformation_weight", "K", costs,
         "Weight of how much the cost of an edge differs between frames (default 0)",
         number<Options>(&Options::deformation_weight, "a number like 1", weight)},
        {"feature_weight", "K", costs,
         "Weight of boundaries and sharp edges in the first and the last frame (default 0)",
         number<Options>(&Options::feature_weight, "a number like 0.5", weight)},
        {"max_normal_deviation", "ANGLE", costs,
         "A collapse costs more if it turns a face of some frame by more degrees (default 45)",
         number<Options>(&Options::max_normal_deviation, "an angle like 60, in degrees",
                         {0, 90, true, false, "an angle above 0 and at most 90 degrees"})},
        {"per_frame", "SHARE", costs,
         "Part of the collapses that follow each frame's own cost: 0.04 or 4% (default 0: all "
         "frames have the same faces)",
         ratio<Options>(&Options::per_frame, {0, 1, false, false, "a part from 0 to 1 (or 100%)"})},
        {"fit", "N", costs,
         "Move the vertices of each frame N times to where it is nearest to its original (default "
         "2)",
         count<Options>(&Options::fit, 0, 100, "0 to 100 passes")},
        from_option<Options>(&Options::from, "from", "all inputs"),
        {"normals", "", result_group,
         "Write vertex normals computed from the result instead of the input's",
         flag<Options>(&Options::normals)}};
    add_output_options(table);
    return table;
  }();
  return options;
}

}  // namespace winnow
