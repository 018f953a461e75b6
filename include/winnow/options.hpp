// The options of every call as tables. The program's command line with its help and manual, the
// manifest of a checkpoint and bindings to other languages are made from them.
#pragma once

#include <winnow/api.hpp>
#include <winnow/compare.hpp>
#include <winnow/context.hpp>
#include <winnow/convert.hpp>
#include <winnow/progressive.hpp>
#include <winnow/sequence.hpp>
#include <winnow/simplify.hpp>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// How the value of one field is written as text.
template <typename Options>
struct OptionValue {
  // Throws Error(usage), naming `option`, where the text is no such value or out of its range.
  std::function<void(Options&, const std::string& text, const std::string& option)> set;
  // What set() takes back to the same value; empty where the field has its default.
  std::function<std::string(const Options&)> get;
  std::vector<std::string> words{};  // that it takes, where it takes words
  bool others = false;               // it takes other text as well
};

template <typename Options>
struct Option {
  std::string name;   // "max_normal_deviation"; the program says --max-normal-deviation
  std::string takes;  // what stands for its value in help: "ANGLE"; empty for a flag
  std::string group;  // the heading it stands under; empty: none
  std::string help;   // what it does, with units and default; one line
  OptionValue<Options> value;

  [[nodiscard]] bool flag() const { return takes.empty(); }
  void set(Options& options, const std::string& text) const { value.set(options, text, name); }
  [[nodiscard]] std::string get(const Options& options) const { return value.get(options); }
};

// Each field is in its table once, in the order of help.
WINNOW_API std::span<const Option<SimplifyOptions>> simplify_options();
WINNOW_API std::span<const Option<ConvertOptions>> convert_options();
WINNOW_API std::span<const Option<CompareOptions>> compare_options();
WINNOW_API std::span<const Option<ProgressiveOptions>> progressive_options();
WINNOW_API std::span<const Option<ExtractOptions>> extract_options();
WINNOW_API std::span<const Option<SequenceOptions>> sequence_options();
WINNOW_API std::span<const Option<Context>> context_options();  // memory, threads, scratch

// Messages and notes name options in backticks, "`faces` takes at least 4", and so they do with the
// calls simplify, resume, convert and info. The same text with each of these names as `spelled`
// gives it.
WINNOW_API std::string spell_options(
    const std::string& text, const std::function<std::string(const std::string& name)>& spelled);

}  // namespace winnow
