// The tables of options know every field, and text goes there and back without loss.
#include <winnow/error.hpp>
#include <winnow/options.hpp>

#include "generate/generate.hpp"
#include "support/field_count.hpp"
#include "support/job.hpp"

#include <limits>
#include <set>
#include <string>
#include <vector>

namespace winnow::test {

namespace {

// A text that the option takes and that differs from its default, so that no new option is
// forgotten here.
template <typename Options>
std::string sample_of(const Option<Options>& option) {
  std::vector<std::string> texts{"true",         "0,1,2,3,4,5.5",      "1,-2,0.5", "0.123456789%",
                                 "30.25",        "123456789012345678", "64M",      "14",
                                 "normals,a\\,b"};
  if (!option.value.others) {
    const std::vector<std::string>& words = option.value.words;
    texts.insert(texts.begin(), words.begin(), words.end());
  }
  for (const std::string& text : texts) {
    Options options;
    try {
      option.set(options, text);
    } catch (const Error&) {
      continue;
    }
    if (!option.get(options).empty()) return text;
  }
  FAIL("no sample for " << option.name << "; add one");
  return {};
}

// Every option changes a field of its own and no other, and comes back from its text.
template <typename Options>
void check_table(std::span<const Option<Options>> table) {
  std::set<std::string> names;
  for (const Option<Options>& option : table) {
    INFO(option.name);
    CHECK(names.insert(option.name).second);
    CHECK_FALSE(option.help.empty());
    Options options;
    CHECK(option.get(options).empty());
    option.set(options, sample_of(option));
    for (const Option<Options>& other : table)
      CHECK(other.get(options).empty() == (other.name != option.name));
    const std::string text = option.get(options);
    Options again;
    option.set(again, text);
    CHECK(option.get(again) == text);
    for (const std::string& word : option.value.words) option.set(again, word);
  }
}

}  // namespace

TEST_CASE("every field of the options is in its table once", "[options]") {
  // Those of Encoding count for themselves, and so do the five kinds of targets, of which several
  // are one option with the first; a view and its viewer are one option.
  const std::size_t encoding = field_count<Encoding>() - 1;
  CHECK(simplify_options().size() == field_count<SimplifyOptions>() + encoding + 3);
  CHECK(convert_options().size() == field_count<ConvertOptions>() + encoding);
  // Two kinds of targets.
  CHECK(sequence_options().size() == field_count<SequenceOptions>() + encoding + 1);
  CHECK(compare_options().size() == field_count<CompareOptions>() - 1);
  CHECK(generate_options().size() == field_count<GenerateOptions>());
  CHECK(progressive_options().size() == field_count<ProgressiveOptions>());
  CHECK(extract_options().size() == field_count<ExtractOptions>() + encoding + 2);
  check_table(simplify_options());
  check_table(progressive_options());
  check_table(extract_options());
  check_table(convert_options());
  check_table(sequence_options());
  check_table(compare_options());
  check_table(generate_options());
  check_table(context_options());
}

TEST_CASE("an option's value comes back from its text bit for bit", "[options]") {
  const auto find = [](const char* name) {
    for (const Option<SimplifyOptions>& option : simplify_options()) {
      if (option.name == name) return option;
    }
    FAIL(name);
    return simplify_options().front();
  };
  const Option<SimplifyOptions> error = find("error"), cell = find("cell"), faces = find("faces"),
                                attributes = find("attributes");
  double value = 0x1.23456789abcdp-60;
  for (int i = 0; i < 1000; ++i) {
    value *= 1.0731;
    const Distance distance = i % 2 == 0 && value < 1 ? Distance::of_diagonal(value) : value;
    const std::uint64_t count = (std::uint64_t{1} << (i % 60 + 2)) + static_cast<std::uint64_t>(i);
    for (const auto& [option, target] :
         {std::pair(&error, Target::error(distance)), std::pair(&cell, Target::cell(value)),
          std::pair(&faces, Target::faces(count))}) {
      SimplifyOptions options, again;
      options.target = target;
      option->set(again, option->get(options));
      CHECK(again.target == target);
    }
  }
  using Names = std::vector<std::string>;
  for (const Names& names : {Names{}, Names{"none"}, Names{"auto"}, Names{"a,b", "c\\", "\\,"}}) {
    SimplifyOptions options, again;
    options.attributes = names;
    attributes.set(again, attributes.get(options));
    CHECK(again.attributes == names);
  }
}

TEST_CASE("of several targets none is taken", "[options]") {
  const std::span<const Option<SimplifyOptions>> kinds = simplify_options().first(5);
  for (const Option<SimplifyOptions>& first : kinds) {
    for (const Option<SimplifyOptions>& second : kinds) {
      SimplifyOptions options;
      first.set(options, sample_of(first));
      const Target target = options.target;
      CHECK(target.kind() != Target::Kind::none);
      const Error error = error_of([&] { second.set(options, sample_of(second)); });
      CHECK(error.kind() == ErrorKind::usage);
      CHECK(std::string(error.what()).find("exactly one of `faces`") != std::string::npos);
      CHECK(options.target == target);
    }
  }
}

TEST_CASE("a hundredth is rounded once", "[options]") {
  for (const Option<SimplifyOptions>& option : simplify_options()) {
    if (option.name != "ratio") continue;
    for (const auto& [text, value] :
         {std::pair{"0.1%", 0.001}, std::pair{"1%", 0.01}, std::pair{"100%", 1.0},
          std::pair{"5e-1%", 0.005}, std::pair{"0.07%", 0.0007}}) {
      SimplifyOptions options;
      option.set(options, text);
      CHECK(options.target == Target::ratio(value));
    }
  }
}

TEST_CASE("what an option does not take is an error that names it", "[options]") {
  for (const Option<SimplifyOptions>& option : simplify_options()) {
    if (option.name == "attributes" || option.name == "map") continue;  // names, whatever they are
    for (const char* text : {"", "x", "nan", "1;2", "-1e999"}) {
      INFO(option.name << " " << text);
      SimplifyOptions options;
      const Error error = error_of([&] { option.set(options, text); });
      CHECK(error.kind() == ErrorKind::usage);
      CHECK(std::string(error.what()).starts_with("`" + option.name + "` takes "));
    }
  }
}

TEST_CASE("names of options in messages are spelled as they are wanted", "[options]") {
  const auto dashes = [](const std::string& name) { return "--" + name; };
  CHECK(spell_options("`faces` takes `x`, `keep_pieces", dashes) ==
        "--faces takes `x`, `keep_pieces");
  CHECK(spell_options("``cell`` and `grid`", dashes) == "`--cell` and --grid");
  CHECK(spell_options("go on by `resume`", dashes) == "go on by --resume");
  CHECK(spell_options("", dashes).empty());
}

}  // namespace winnow::test
