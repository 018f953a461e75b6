#include "usage_errors.hpp"

#include <winnow/error.hpp>

#include "numbers.hpp"
#include "program.hpp"

#include <algorithm>
#include <numeric>

namespace winnow::cli {

namespace {

constexpr char small(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Damerau's distance, with letters next to each other swapped once at most. Capital letters of `a`
// are the small ones.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  std::iota(cost[0].begin(), cost[0].end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    cost[i][0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = small(a[i - 1]) == b[j - 1];
      cost[i][j] =
          std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + (same ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  }
  return cost[a.size()][b.size()];
}

// "; did you mean 'simplify'?"
std::string hint(std::string_view text, const std::vector<std::string>& words) {
  const std::string near = nearest(text, words);
  return near.empty() ? "" : "; did you mean '" + near + "'?";
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::string unknown_option(const CLI::App& command, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  const std::string name = word.substr(0, word.find('='));
  return command.get_name() + " has no option '" + clean(name) + "'" + hint(name, names);
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

}  // namespace

std::string nearest(std::string_view text, const std::vector<std::string>& words) {
  // Longer words, as a file's name, are no slip of the hand, and would take time.
  if (text.size() > 40) return "";
  std::string near;
  std::size_t least = text.size() / 3 + 1;
  for (const std::string& word : words) {
    const bool begins = text.size() > 2 && word.starts_with(text);
    const std::size_t distance = begins ? 1 : edits(text, word);
    if (distance > least || (distance == least && !near.empty())) continue;
    least = distance;
    near = word;
  }
  return near;
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ",") + word;
  return CLI::Validator(
      [words](std::string& text) {
        if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
        return "'" + clean(text) + "' is not one of " + show_list(words) + hint(text, words);
      },
      "{" + list + "}");
}

void refuse_unknown_command(const CLI::App& app, const std::string& word) {
  if (is_option(word)) return;
  const std::vector<std::string> commands = commands_of(app);
  if (std::find(commands.begin(), commands.end(), word) != commands.end()) return;
  const std::string near = hint(word, commands);
  throw Error(ErrorKind::usage, "'" + word + "' is no command" +
                                    (near.empty() ? "; there are " + show_list(commands) : near));
}

std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = parsed_command(app);
  const bool named = &command != &app;
  std::vector<std::string> left = app.remaining();
  if (named) {
    const std::vector<std::string> own = command.remaining();
    left.insert(left.end(), own.begin(), own.end());
  }
  // An option that is spelled wrong may be the one that is missing, so it comes before that.
  for (const std::string& word : left) {
    if (is_option(word)) return unknown_option(command, word);
  }
  if (!left.empty())
    return command.get_name() + ": '" + clean(left.front()) + "' is one argument too many";
  if (!named) return "say what to do: " + show_list(commands_of(app));
  for (const CLI::Option* option : command.get_options()) {
    const auto values = static_cast<int>(option->results().size());
    if (values > option->get_items_expected_max())
      return option->get_name() + " is given more than once";
  }
  for (const CLI::Option* option : command.get_options()) {
    const auto values = static_cast<int>(option->results().size());
    if (values > 0 && values < option->get_items_expected_min())
      return option->get_name() + " takes " + std::to_string(option->get_items_expected_min()) +
             " values, not " + std::to_string(values);
  }
  if (const auto* mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    const std::string text = mismatch->what();
    if (text.ends_with(" missing")) return text.substr(0, text.find(':')) + " needs a value";
  }
  return error.what();
}

}  // namespace winnow::cli
