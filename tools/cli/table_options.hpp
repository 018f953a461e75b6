// A command's options from a table of the library.
#pragma once

#include <winnow/error.hpp>
#include <winnow/options.hpp>

#include "numbers.hpp"
#include "usage_errors.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace winnow::cli {

// "--max-normal-deviation" for "max_normal_deviation".
std::string flag_called(std::string name);

// A text of the library as this program says it.
std::string spoken(const std::string& text);

// The same of a text that names `option`, which may be one of this program alone.
std::string spoken(const std::string& text, const std::string& option);

// The same of each.
std::vector<std::string> spoken(std::vector<std::string> texts);

// "VIEW:{front,top,...}": what help shows for a value that may be one of `words`.
std::string open_choice(const std::string& takes, const std::vector<std::string>& words);

// Adds the options of `table`, and reads what the command line says of them.
template <typename Options>
class TableOptions {
 public:
  explicit TableOptions(std::span<const Option<Options>> table) : table_(table) {}

  // Those with these names, or with none named all.
  void add_to(CLI::App& command, const std::vector<std::string>& names = {}) {
    for (const Option<Options>& option : table_) {
      if (names.empty() || std::find(names.begin(), names.end(), option.name) != names.end())
        add_named(command, option);
    }
  }
  // One of them as an argument by its place.
  void add_positional(CLI::App& command, const std::string& name) {
    const Option<Options>& option = *std::find_if(
        table_.begin(), table_.end(), [&](const auto& entry) { return entry.name == name; });
    add(command, option, name)->required();
  }
  // Text for the help of one option, where the command knows better.
  void describe(const std::string& name, const std::string& help) {
    for (auto& [option, asked] : added_) {
      if (option->name == name) asked->description(help);
    }
  }
  // Whether the command line names it.
  [[nodiscard]] bool given(const std::string& name) const {
    return std::any_of(added_.begin(), added_.end(), [&](const auto& entry) {
      return entry.first->name == name && entry.second->count() > 0;
    });
  }

  // Once the command line is parsed. Throws Error(usage).
  void read(Options& options) const {
    for (const auto& [option, asked] : added_) {
      if (asked->count() == 0) continue;
      try {
        option->set(options, option->flag() ? "true" : asked->results().back());
      } catch (const Error& error) {
        throw Error(error.kind(), spoken(error.what(), option->name));
      }
    }
  }

 private:
  void add_named(CLI::App& command, const Option<Options>& option) {
    CLI::Option* asked =
        option.flag() ? command.add_flag_function(
                            flag_called(option.name), [](std::int64_t) {}, spoken(option.help))
                      : add(command, option, flag_called(option.name));
    if (option.flag()) added_.emplace_back(&option, asked);
    if (!option.group.empty()) asked->group(option.group);
  }
  CLI::Option* add(CLI::App& command, const Option<Options>& option, const std::string& name) {
    CLI::Option* asked = command.add_option_function<std::string>(
        name, [](const std::string&) {}, spoken(option.help));
    const OptionValue<Options>& value = option.value;
    asked->type_name(value.others ? open_choice(option.takes, value.words) : option.takes);
    if (!value.words.empty() && !value.others) asked->check(one_of(value.words));
    added_.emplace_back(&option, asked);
    return asked;
  }

  std::span<const Option<Options>> table_;
  std::vector<std::pair<const Option<Options>*, CLI::Option*>> added_;
};

}  // namespace winnow::cli
