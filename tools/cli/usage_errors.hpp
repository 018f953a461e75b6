// What is wrong with a command line, in words that name it and the way out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace winnow::cli {

// The word that takes the fewest letters more, less, other or swapped to become `text`; empty if
// none is near.
std::string nearest(std::string_view text, const std::vector<std::string>& words);

// Of an option that takes one of these words.
CLI::Validator one_of(const std::vector<std::string>& words);

// Throws Error(usage) where the first word of a command line is no option and no command.
void refuse_unknown_command(const CLI::App& app, const std::string& word);

// What `error` means for who typed the command line that `app` has parsed.
std::string explain(const CLI::App& app, const CLI::ParseError& error);

}  // namespace winnow::cli
