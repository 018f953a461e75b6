// The table of compare().
#include "options/option_kinds.hpp"
#include "options/shared_entries.hpp"

#include <limits>

namespace winnow {

namespace {

OptionValue<CompareOptions> view() {
  using Words = std::vector<std::pair<const char*, View>>;
  const OptionValue<CompareOptions> words = choice<CompareOptions>(
      &CompareOptions::view, Words{{"front", View::front}, {"top", View::top}, {"iso", View::iso}});
  OptionValue<CompareOptions> value;
  value.words = words.words;
  value.others = true;
  value.set = [words](CompareOptions& options, const std::string& text, const std::string& option) {
    for (const std::string& word : words.words) {
      if (text == word) return words.set(options, text, option);
    }
    numbers_in(text, option, "front, top, iso, or X,Y,Z like 1,-2,0.5, the direction to the viewer",
               options.viewer);
    if (options.viewer == std::array<double, 3>{})
      throw Error(ErrorKind::usage,
                  "`" + option + "` takes a direction of finite numbers that are not all 0");
    options.view = View::from;
  };
  value.get = [words](const CompareOptions& options) {
    return options.view == View::from ? text_of(options.viewer) : words.get(options);
  };
  return value;
}

}  // namespace

std::span<const Option<CompareOptions>> compare_options() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr NumberRange from_zero{0, infinity, false, true, "a distance of 0 or more"};
  static const std::vector<Option<CompareOptions>> options{
      {"samples", "N", "",
       "Number of points on each surface, spread evenly by area (default 1M). The maximum also "
       "counts all vertices.",
       count<CompareOptions>(&CompareOptions::samples, 100, 1'000'000'000'000,
                             "100 to 1,000,000,000,000")},
      {"colored", "FILE.ply", "",
       "Write the simplified mesh, coloured by its distance, which is also stored as 'quality'",
       text<CompareOptions>(&CompareOptions::colored)},
      {"picture", "FILE.png", "",
       "Draw the original and the simplified mesh side by side, coloured by distance",
       text<CompareOptions>(&CompareOptions::picture)},
      {"view", "VIEW", "",
       "Where the picture is seen from: front, top, iso (default), or X,Y,Z, the direction to the "
       "viewer",
       view()},
      {"fail_above", "DISTANCE", "",
       "End with exit code 1 if the symmetric RMS distance is above this: 0.5 (model units) or "
       "0.1% (of the diagonal)",
       distance<CompareOptions>(&CompareOptions::fail_above, from_zero, from_zero)},
      {"force", "", "", "Replace existing files", flag<CompareOptions>(&CompareOptions::force)},
      from_option<CompareOptions>(&CompareOptions::from_original, "from_original", "the original"),
      from_option<CompareOptions>(&CompareOptions::from_simplified, "from_simplified",
                                  "the simplified mesh")};
  return options;
}

}  // namespace winnow
