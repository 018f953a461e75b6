#include "help_formatter.hpp"

#include <algorithm>
#include <sstream>

namespace winnow::cli {

namespace {

constexpr std::size_t columns = 100;
constexpr std::size_t text_column = 30;

// "  name    text", with the text in a column of its own, below the name where that is too long.
std::string entry(const std::string& name, const std::string& text) {
  std::string out = "  " + name;
  std::size_t at = out.size();
  const auto indent = [&] {
    out.append(1, '\n').append(text_column, ' ');
    at = text_column;
  };
  if (at >= text_column) {
    indent();
  } else {
    out.append(text_column - at, ' ');
    at = text_column;
  }
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (at > text_column && at + 1 + word.size() > columns) indent();
    if (at > text_column) out += ' ';
    at += word.size() + (at > text_column ? 1 : 0);
    out += word;
  }
  return out + "\n";
}

}  // namespace

std::string HelpFormatter::make_option(const CLI::Option* option, bool positional) const {
  return entry(make_option_name(option, positional) + make_option_opts(option),
               make_option_desc(option));
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return entry(command->get_display_name(true), command->get_description());
}

std::string HelpFormatter::make_footer(const CLI::App* command) const {
  return CLI::Formatter::make_footer(command) +
         "\nExit codes: 0 done, 1 failed otherwise, 2 usage, 3 bad input, 4 memory or disk, 130 "
         "interrupted.\n";
}

}  // namespace winnow::cli
