// The help of the program and of its commands. No line is longer than 100 columns, and the exit
// codes stand at the end.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace winnow::cli {

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_footer(const CLI::App* command) const override;
};

}  // namespace winnow::cli
