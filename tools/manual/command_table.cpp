#include "manual/command_table.hpp"

#include "cli/program.hpp"

#include <algorithm>
#include <sstream>

namespace winnow::manual {

namespace {

// "HOW:{mean,quadric}": what the program's own help shows.
void set_value(OptionLine& line, const std::string& type) {
  const std::size_t open = type.find('{');
  line.value = type.substr(0, type.find(':'));
  if (open == std::string::npos) return;
  std::istringstream in(type.substr(open + 1, type.find('}') - open - 1));
  for (std::string choice; std::getline(in, choice, ',');) {
    // Values of other forms are in the description, with these.
    if (choice == "...") {
      line.open = true;
    } else {
      line.choices.push_back(choice);
    }
  }
}

OptionLine line_of(const CLI::Option& option) {
  OptionLine line;
  for (const std::string& name : option.get_snames()) line.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) line.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) set_value(line, option.get_type_name());
  line.several = option.get_items_expected_max() > 1;
  line.description = option.get_description();
  line.group = option.get_group();
  return line;
}

void set_footer(CommandTable& table, const std::string& footer) {
  bool examples = false;
  std::istringstream in(footer);
  for (std::string line; std::getline(in, line);) {
    if (line == "Examples:" || line == "Try first:") {
      examples = true;
    } else if (examples && line.starts_with("  ")) {
      table.examples.push_back(line.substr(2));
    } else if (!line.empty()) {
      table.remarks.push_back(line);
    }
  }
}

CommandTable table_of(const CLI::App& command) {
  CommandTable table;
  table.name = command.get_name();
  table.description = command.get_description();
  for (const CLI::Option* option : command.get_options()) table.options.push_back(line_of(*option));
  // Arguments by place come first, as on the command line.
  std::stable_partition(table.options.begin(), table.options.end(),
                        [](const OptionLine& line) { return line.positional(); });
  set_footer(table, command.get_footer());
  return table;
}

}  // namespace

bool OptionLine::takes_file() const {
  for (const char* kind : {"IN", "OUT", "DIR", "ORIGINAL", "SIMPLIFIED"}) {
    if (value == kind) return true;
  }
  return value.starts_with("FILE");
}

std::vector<CommandTable> command_tables() {
  CLI::App app;
  cli::add_commands(app);
  std::vector<CommandTable> tables{table_of(app)};
  for (const CLI::App* command : app.get_subcommands({})) tables.push_back(table_of(*command));
  return tables;
}

}  // namespace winnow::manual
