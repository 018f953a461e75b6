// The table of extract().
#include "options/option_kinds.hpp"
#include "options/shared_entries.hpp"
#include "options/target_kind.hpp"

namespace winnow {

namespace {

void refuse_extracted() {
  throw Error(ErrorKind::usage, "say how fine with exactly one of `faces`, `ratio` and `error`");
}

}  // namespace

std::span<const Option<ExtractOptions>> extract_options() {
  using Options = ExtractOptions;
  static const std::vector<Option<Options>> options = [] {
    const char* const group = "How fine (exactly one)";
    std::vector<Option<Options>> table{
        {"faces", "N", group, "Extract this many faces: 500k, 1.5M; at most one collapse less",
         target<Options, std::uint64_t>(
             &Target::faces, &Target::faces,
             [](const std::string& text, const std::string& option) {
               return count_in(text, option, 4, std::uint64_t{1} << 62, "at least 4");
             },
             refuse_extracted)},
        {"ratio", "R", group, "Extract this part of all faces: 0.01 or 1%; 100% is the input",
         target<Options, double>(
             &Target::ratio, &Target::ratio,
             [](const std::string& text, const std::string& option) {
               return ratio_in(text, option, ratio_range);
             },
             refuse_extracted)},
        {"error", "E", group,
         "Extract the coarsest level within this error: 0.5 (model units) or 0.1% (of the "
         "diagonal); it bounds what 'simplify' bounds, and nothing is unfolded",
         target<Options, Distance>(
             &Target::error, &Target::error,
             [](const std::string& text, const std::string& option) {
               return distance_in(text, option, length_range, part_range);
             },
             refuse_extracted)},
        {"raw", "", result_group,
         "Write vertices where the file has them; by default some are moved where faces are "
         "flipped",
         flag<Options>(&Options::raw)},
        {"normals", "", result_group, "Write vertex normals computed from the result",
         flag<Options>(&Options::normals)}};
    add_output_options(table);
    return table;
  }();
  return options;
}

}  // namespace winnow
