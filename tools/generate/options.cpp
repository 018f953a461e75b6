#include "generate/generate.hpp"
#include "options/option_kinds.hpp"
#include "options/shared_entries.hpp"

#include <limits>

namespace winnow {

namespace {

OptionValue<GenerateOptions> seed() {
  return count<GenerateOptions>(&GenerateOptions::seed, 0,
                                std::numeric_limits<std::uint32_t>::max(),
                                "a whole number below 2^32");
}

}  // namespace

std::span<const Option<GenerateOptions>> generate_options() {
  using Surfaces = std::vector<std::pair<const char*, Surface>>;
  static const std::vector<Option<GenerateOptions>> options{
      {"surface", "SURFACE", "",
       "What to make: scan (closed, curved, noisy), terrain (with a boundary) or part (like CAD)",
       choice<GenerateOptions>(&GenerateOptions::surface, Surfaces{{"scan", Surface::scan},
                                                                   {"terrain", Surface::terrain},
                                                                   {"part", Surface::part}})},
      {"faces", "N", result_group, "Make about this many faces: 500k, 20M, 1G (default 1M)",
       count<GenerateOptions>(&GenerateOptions::faces, 0, std::uint64_t{1} << 62,
                              "a count below 2^62")},
      {"seed", "N", result_group,
       "Another number makes another surface of the same kind (default 1)", seed()},
      {"shuffle", "", result_group, "Write the faces in a scattered order",
       flag<GenerateOptions>(&GenerateOptions::shuffle)},
      {"offset", "X,Y,Z", result_group,
       "Add this to every position, as in georeferenced scans; PLY then holds doubles",
       triple<GenerateOptions>(&GenerateOptions::offset, "three numbers like 431000,5412000,300")},
      {"to", "FORMAT", result_group, "Output format, where the name's ending does not tell",
       choice<GenerateOptions>(&GenerateOptions::to, format_words(FormatUse::generated))},
      {"force", "", result_group, "Replace the output if it exists",
       flag<GenerateOptions>(&GenerateOptions::force)}};
  return options;
}

}  // namespace winnow
