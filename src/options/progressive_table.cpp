// The table of progressive().
#include "options/option_kinds.hpp"
#include "options/shared_entries.hpp"

namespace winnow {

namespace {

std::vector<std::pair<const char*, Refine>> cost_words() {
  std::vector<std::pair<const char*, Refine>> words = words_of<Refine>();
  std::erase_if(words, [](const auto& word) { return word.second == Refine::none; });
  return words;
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
      boundary_option<Options>(
          "",
          "Open boundaries: 'weigh' moves them at a cost (default), 'keep' fixes their vertices"),
      topology_option<Options>("",
                               "Handles and holes: 'keep' them in all levels (default), or be "
                               "'free' to close them in coarse ones"),
      {"attributes", "LIST", "",
       "Vertex attributes to carry: auto (default: all numbers), none, or a list such as "
       "normals,colors,quality",
       attribute_list<Options>()},
      strict_option<Options>(),
      crop_option<Options>(),
      weld_option<Options>(),
      from_option<Options>(&Options::from),
      {"force", "", "", "Replace the output if it exists", flag<Options>(&Options::force)}};
  return options;
}

}  // namespace winnow
