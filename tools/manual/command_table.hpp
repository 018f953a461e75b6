// The command line as a table: what man pages and completions are made of.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace winnow::manual {

struct OptionLine {
  std::vector<std::string> names;  // "-o", "--output"; none where it is known by its place
  std::string value;               // "OUT"; empty for a flag
  std::vector<std::string> choices;
  bool open = false;     // whether it takes more than the choices
  bool several = false;  // whether more than one value may follow
  std::string description;
  std::string group;

  [[nodiscard]] bool positional() const { return names.empty(); }
  // Whether the value is a name of a file or directory.
  [[nodiscard]] bool takes_file() const;
  [[nodiscard]] bool takes_directory() const { return value == "DIR"; }
};

struct CommandTable {
  std::string name;  // "simplify"
  std::string description;
  std::vector<OptionLine> options;
  std::vector<std::string> remarks;   // lines of the help's end, and ...
  std::vector<std::string> examples;  // ... its examples
};

// The program's commands in their order; the first is the program itself.
std::vector<CommandTable> command_tables();

// The text of `winnow.1` (for the first table) or `winnow-COMMAND.1`.
std::string man_page(const CommandTable& command, const std::vector<CommandTable>& all);

std::string bash_completion(const std::vector<CommandTable>& all);
std::string zsh_completion(const std::vector<CommandTable>& all);
std::string fish_completion(const std::vector<CommandTable>& all);

}  // namespace winnow::manual
