// The kind of option that says how fine a result shall be.
#pragma once

#include "options/option_kinds.hpp"
#include "options/refuse_targets.hpp"

#include <limits>
#include <optional>
#include <string>
#include <type_traits>

namespace winnow {

inline constexpr NumberRange length_range{0, std::numeric_limits<double>::infinity(), true, true,
                                          "a length above 0"};
inline constexpr NumberRange part_range{0, 1, true, true,
                                        "a part of the diagonal above 0 and below 100%"};
inline constexpr NumberRange ratio_range{0, 1, true, false,
                                         "a part above 0 and at most 1 (or 100%)"};

// One kind of target, of which only one can be given; else this is told.
template <typename Options, typename Value, typename Read>
OptionValue<Options> target(Target (*make)(Value), std::optional<Value> (Target::*value)() const,
                            Read read, void (*refuse)() = refuse_targets) {
  OptionValue<Options> kind;
  kind.set = [=](Options& options, const std::string& text, const std::string& option) {
    const Target read_target = make(read(text, option));
    if (options.target.kind() != Target::Kind::none) refuse();
    options.target = read_target;
  };
  kind.get = [=](const Options& options) -> std::string {
    const std::optional<Value> now = (options.target.*value)();
    if (!now) return "";
    if constexpr (std::is_same_v<Value, Distance>) {
      return text_of(*now);
    } else if constexpr (std::is_same_v<Value, double>) {
      return shortest(*now);
    } else {
      return std::to_string(*now);
    }
  };
  return kind;
}

}  // namespace winnow
