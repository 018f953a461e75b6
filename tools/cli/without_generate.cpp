// In the place of generate_command.cpp in a program without that command.
#include <winnow/error.hpp>

#include "program.hpp"

namespace winnow::cli {

void add_generate(CLI::App& app) {
  CLI::App* command = app.add_subcommand("generate", "Make a surface of any size (not built)");
  command->allow_extras();
  command->callback([] {
    throw Error(
        ErrorKind::failed,
        "this winnow was built without the command generate; build it with -DWINNOW_GENERATE=ON");
  });
}

bool has_generate() {
  return false;
}

}  // namespace winnow::cli
