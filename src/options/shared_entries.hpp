// The options of reading and writing that calls share.
#pragma once

#include "options/option_kinds.hpp"
#include "options/target_kind.hpp"

namespace winnow {

inline constexpr const char* input_group = "What is read";
inline constexpr const char* result_group = "What the result is";

inline std::vector<std::pair<const char*, Format>> format_words(FormatUse use) {
  std::vector<std::pair<const char*, Format>> words{
      {facts_of(Format::automatic).name, Format::automatic}};
  for (const Format format : all_values<Format>()) {
    if (!serves(format, use)) continue;
    for (const char* ending : facts_of(format).endings) {
      if (ending != nullptr) words.emplace_back(ending, format);
      if (use != FormatUse::read) break;
    }
  }
  return words;
}

template <typename Options, typename Field>
Option<Options> from_option(Field field, const char* name = "from",
                            const char* what = "the input") {
  return {name, "FORMAT", input_group,
          std::string("Read ") + what + " as this format, whatever its content looks like",
          choice<Options>(field, format_words(FormatUse::read))};
}

template <typename Options>
Option<Options> strict_option() {
  return {"strict", "", input_group,
          "Stop at the first bad face; by default bad faces are left out and counted",
          flag<Options>(&Options::strict)};
}

template <typename Options>
Option<Options> boundary_option(const char* group, const char* help) {
  return {"boundary", "HOW", group, help,
          choice<Options>(&Options::boundary,
                          std::vector<std::pair<const char*, Boundary>>{{"weigh", Boundary::weigh},
                                                                        {"keep", Boundary::keep}})};
}

template <typename Options>
Option<Options> topology_option(const char* group, const char* help) {
  return {
      "topology", "HOW", group, help,
      choice<Options>(&Options::topology, std::vector<std::pair<const char*, Topology>>{
                                              {"keep", Topology::keep}, {"free", Topology::free}})};
}

// The sides of a box.
template <typename Options>
OptionValue<Options> crop() {
  constexpr const char* examples =
      "six numbers like 0,0,0,10,10,5: the low and the high corner of a box";
  OptionValue<Options> value;
  value.set = [](Options& options, const std::string& text, const std::string& option) {
    std::array<double, 6> numbers{};
    numbers_in(text, option, examples, numbers);
    const auto& [a, b, c, d, e, f] = numbers;
    if (!(a <= d && b <= e && c <= f))
      throw Error(ErrorKind::usage,
                  "`" + option + "` takes the low and then the high corner of a box");
    options.crop = {{{a, b, c}, {d, e, f}}};
  };
  value.get = [](const Options& options) -> std::string {
    if (!options.crop) return "";
    return text_of((*options.crop)[0]) + "," + text_of((*options.crop)[1]);
  };
  return value;
}

template <typename Options>
Option<Options> crop_option() {
  return {"crop", "BOX", input_group,
          "Keep only faces wholly inside this box (model units): xmin,ymin,zmin,xmax,ymax,zmax",
          crop<Options>()};
}

template <typename Options>
Option<Options> weld_option() {
  return {"weld", "DISTANCE", input_group,
          "Join vertices closer than this: 0.01 (model units) or 0.001% (of the diagonal). Chains "
          "of such vertices are joined too.",
          distance<Options>(&Options::weld, length_range, part_range)};
}

// `attributes`. "none" is an empty list, "auto" no list at all.
template <typename Options>
OptionValue<Options> attribute_list() {
  OptionValue<Options> value;
  value.set = [](Options& options, const std::string& text, const std::string& option) {
    if (text == "auto") {
      options.attributes.reset();
    } else if (text == "none") {
      options.attributes.emplace();
    } else {
      options.attributes = names_in(text, option);
    }
  };
  value.get = [](const Options& options) -> std::string {
    if (!options.attributes) return "";
    if (options.attributes->empty()) return "none";
    const std::string names = text_of(*options.attributes);
    return names == "none" || names == "auto" ? "\\" + names : names;
  };
  return value;
}

// Adds those of how the output is written: `to`, the fields of Encoding and `force`.
template <typename Options>
void add_output_options(std::vector<Option<Options>>& table) {
  const auto encoding = [](auto member) {
    return [member](auto& options) -> auto& {
      return options.encoding.*member;
    };
  };
  table.insert(
      table.end(),
      {{"to", "FORMAT", result_group, "Output format, where the name's ending does not tell",
        choice<Options>(&Options::to, format_words(FormatUse::written))},
       {"ascii", "", result_group, "Write PLY and STL as text",
        flag<Options>(encoding(&Encoding::ascii))},
       {"positions", "TYPE", result_group,
        "Type of positions (default: the input's; STL and GLB hold floats)",
        choice<Options>(encoding(&Encoding::positions),
                        std::vector<std::pair<const char*, Positions>>{
                            {"float", Positions::floats}, {"double", Positions::doubles}})},
       {"compress", "HOW", result_group,
        "How to pack a GLB: none (default) or meshopt (EXT_meshopt_compression, without loss)",
        choice<Options>(encoding(&Encoding::compress),
                        std::vector<std::pair<const char*, Compression>>{
                            {"none", Compression::none}, {"meshopt", Compression::meshopt}})},
       {"quantize", "BITS", result_group,
        "GLB: positions in 1 to 16 bits, normals in 8 (KHR_mesh_quantization)",
        count<Options>(encoding(&Encoding::quantize), 1, 16, "1 to 16 bits")},
       {"up", "AXIS", result_group, "GLB: the axis of the model that points up: y (default) or z",
        choice<Options>(
            encoding(&Encoding::up),
            std::vector<std::pair<const char*, UpAxis>>{{"y", UpAxis::y}, {"z", UpAxis::z}})},
       {"force", "", result_group, "Replace the output if it exists",
        flag<Options>(&Options::force)}});
}

}  // namespace winnow
