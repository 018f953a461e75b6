// The tables of progressive() and extract().
#include "options/option_kinds.hpp"
#include "options/shared_entries.hpp"

namespace winnow {

namespace {

std::vector<std::pair<const char*, Refine>> cost_words() {
  std::vector<std::pair<const char*, Refine>> words = words_of<Refine>();
  std::erase_if(words, [](const auto& word) { return word.second == Refine::none; });
  return words;
}

// Of the two kinds of targets only one can be given.
template <typename Value, typename Read>
OptionValue<ExtractOptions> fineness(Target (*make)(Value),
                                     std::optional<Value> (Target::*value)() const, Read read) {
  OptionValue<ExtractOptions> kind;
  kind.set = [=](ExtractOptions& options, const std::string& text, const std::string& option) {
    if (options.target.kind() != Target::Kind::none)
      throw Error(ErrorKind::usage, "say how fine with one of `faces` and `ratio`");
    options.target = make(read(text, option));
  };
  kind.get = [=](const ExtractOptions& options) -> std::string {
    const std::optional<Value> now = (options.target.*value)();
    if (!now) return "";
    if constexpr (std::is_same_v<Value, double>) {
      return shortest(*now);
    } else {
      return std::to_string(*now);
    }
  };
  return kind;
}

}  // namespace

std::span<const Option<ProgressiveOptions>> progressive_options() {
  using Options = ProgressiveOptions;
  static const std::vector<Option<Options>> options{
      {"base", "N", "", "Faces of the coarsest mesh, about (default 1k)",
       count<Options>(&Options::base, 4, std::uint64_t{1} << 32, "4 to 4,294,967,296")},
      {"refine", "COST", "", "What an edge costs to collapse (default: quadric)",
       choice<Options>(&Options::refine, cost_words())},
      {"bits", "BITS", "",
       "Store positions as whole numbers of 8 to 24 bits along the longest side, which takes half "
       "the bytes; by default they come back bit for bit",
       count<Options>(&Options::bits, 8, 24, "8 to 24 bits")},
      {"topology", "HOW", "",
       "Handles and holes: 'keep' them in all levels (default), or be 'free' to close them in "
       "coarse ones",
       choice<Options>(&Options::topology,
                       std::vector<std::pair<const char*, Topology>>{{"keep", Topology::keep},
                                                                     {"free", Topology::free}})},
      {"attributes", "LIST", "",
       "Vertex attributes to carry: auto (default: all numbers), none, or a list such as "
       "normals,colors,quality",
       attribute_list<Options>()},
      strict_option<Options>(),
      from_option<Options>(&Options::from),
      {"force", "", "", "Replace the output if it exists", flag<Options>(&Options::force)}};
  return options;
}

std::span<const Option<ExtractOptions>> extract_options() {
  using Options = ExtractOptions;
  static const std::vector<Option<Options>> options = [] {
    const char* const group = "How fine (exactly one)";
    constexpr NumberRange ratio_range{0, 1, true, false, "a part above 0 and at most 1 (or 100%)"};
    std::vector<Option<Options>> table{
        {"faces", "N", group, "Extract this many faces: 500k, 1.5M; at most one collapse less",
         fineness<std::uint64_t>(&Target::faces, &Target::faces,
                                 [](const std::string& text, const std::string& option) {
                                   return count_in(text, option, 4, std::uint64_t{1} << 62,
                                                   "at least 4");
                                 })},
        {"ratio", "R", group, "Extract this part of all faces: 0.01 or 1%; 100% is the input",
         fineness<double>(&Target::ratio, &Target::ratio,
                          [=](const std::string& text, const std::string& option) {
                            return ratio_in(text, option, ratio_range);
                          })},
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
