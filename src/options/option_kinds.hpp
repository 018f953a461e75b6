// Kinds of options: how a field of each type is read from text and written as text. A field is a
// pointer to a member, or a function that finds it in the options.
#pragma once

#include <winnow/error.hpp>
#include <winnow/options.hpp>
#include <winnow/values.hpp>

#include "base/text.hpp"
#include "options/text_values.hpp"

#include <array>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace winnow {

template <typename Options, typename Field>
using FieldOf = std::remove_cvref_t<std::invoke_result_t<Field, Options&>>;

// By `read(text, option)` and `write(value)`; a field that is optional has no default but nothing.
template <typename Options, typename Field, typename Read, typename Write>
OptionValue<Options> by_text(Field field, Read read, Write write) {
  using Value = FieldOf<Options, Field>;
  OptionValue<Options> value;
  value.set = [field, read](Options& options, const std::string& text, const std::string& option) {
    std::invoke(field, options) = static_cast<Value>(read(text, option));
  };
  value.get = [field, write](const Options& options) {
    const Value& now = std::invoke(field, options);
    if constexpr (requires { now.has_value(); }) {
      return now ? write(*now) : std::string();
    } else {
      const Options fresh{};
      return now == std::invoke(field, fresh) ? std::string() : write(now);
    }
  };
  return value;
}

// "true" or "false".
template <typename Options, typename Field>
OptionValue<Options> flag(Field field) {
  return by_text<Options>(
      field,
      [](const std::string& text, const std::string& option) {
        if (text != "true" && text != "false") refuse_value(option, "true or false", text);
        return text == "true";
      },
      [](bool value) { return std::string(value ? "true" : "false"); });
}

template <typename Options, typename Field>
OptionValue<Options> text(Field field) {
  return by_text<Options>(
      field, [](const std::string& text, const std::string& /*option*/) { return text; },
      [](const std::string& value) { return value; });
}

template <typename Options, typename Field>
OptionValue<Options> number(Field field, const char* examples, NumberRange range = {}) {
  return by_text<Options>(
      field,
      [examples, range](const std::string& text, const std::string& option) {
        return number_in(text, option, examples, range);
      },
      shortest);
}

template <typename Options, typename Field>
OptionValue<Options> ratio(Field field, NumberRange range) {
  return by_text<Options>(
      field,
      [range](const std::string& text, const std::string& option) {
        return ratio_in(text, option, range);
      },
      shortest);
}

template <typename Options, typename Field>
OptionValue<Options> distance(Field field, NumberRange length, NumberRange part) {
  return by_text<Options>(
      field,
      [length, part](const std::string& text, const std::string& option) {
        return distance_in(text, option, length, part);
      },
      [](const Distance& value) { return text_of(value); });
}

template <typename Options, typename Field>
OptionValue<Options> count(Field field, std::uint64_t least, std::uint64_t most,
                           const char* words) {
  return by_text<Options>(
      field,
      [=](const std::string& text, const std::string& option) {
        return count_in(text, option, least, most, words);
      },
      [](std::uint64_t value) { return std::to_string(value); });
}

template <typename Options, typename Field>
OptionValue<Options> size(Field field) {
  return by_text<Options>(field, size_in,
                          [](std::uint64_t value) { return std::to_string(value); });
}

// One of `words`; of two words for the same value the first is written.
template <typename Options, typename Field, typename Word>
OptionValue<Options> choice(Field field, std::vector<std::pair<const char*, Word>> words) {
  std::vector<std::string> names;
  std::string list;
  for (const auto& [name, value] : words) {
    names.emplace_back(name);
    list += (list.empty() ? "" : ", ") + names.back();
  }
  OptionValue<Options> value = by_text<Options>(
      field,
      [words, list](const std::string& text, const std::string& option) {
        for (const auto& [name, word] : words) {
          if (text == name) return word;
        }
        refuse_value(option, "one of " + list, text);
      },
      [words](Word word) {
        for (const auto& [name, other] : words) {
          if (word == other) return std::string(name);
        }
        return std::string();
      });
  value.words = std::move(names);
  return value;
}

// The words of an enumeration whose values tell their names.
template <typename Enum>
std::vector<std::pair<const char*, Enum>> words_of() {
  std::vector<std::pair<const char*, Enum>> words;
  for (const Enum value : all_values<Enum>()) words.emplace_back(facts_of(value).name, value);
  return words;
}

// Three numbers with commas between them: std::array<double, 3>.
template <typename Options, typename Field>
OptionValue<Options> triple(Field field, const char* examples) {
  return by_text<Options>(
      field,
      [examples](const std::string& text, const std::string& option) {
        std::array<double, 3> numbers{};
        numbers_in(text, option, examples, numbers);
        return numbers;
      },
      [](const std::array<double, 3>& numbers) { return text_of(numbers); });
}

}  // namespace winnow
