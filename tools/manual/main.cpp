// Writes the man pages and completions of the program, from the options that it takes, into a
// folder.
#include "manual/command_table.hpp"

#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
  using namespace winnow::manual;
  if (argc != 2) {
    std::cerr << "usage: winnow-manual DIR\n";
    return 2;
  }
  const std::string folder = argv[1];
  bool good = true;
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream file(folder + "/" + name, std::ios::binary);
    file << text;
    file.close();
    good &= !file.fail();
  };
  const std::vector<CommandTable> all = command_tables();
  for (const CommandTable& command : all)
    write((command.name == "winnow" ? "winnow" : "winnow-" + command.name) + ".1",
          man_page(command, all));
  write("winnow.bash", bash_completion(all));
  write("_winnow", zsh_completion(all));
  write("winnow.fish", fish_completion(all));
  if (!good) std::cerr << "winnow-manual: cannot write to '" << folder << "'\n";
  return good ? 0 : 1;
}
