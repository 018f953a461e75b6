// The table of the context, which all calls have.
#include "options/option_kinds.hpp"

namespace winnow {

std::span<const Option<Context>> context_options() {
  const char* const group = "Speed and memory (never change the result)";
  static const std::vector<Option<Context>> options{
      {"memory", "SIZE", group, "Memory to use, mapped input pages included (default 512M)",
       size<Context>(&Context::memory)},
      {"threads", "N", group, "Number of threads (default: one for each processor)",
       count<Context>(&Context::threads, 0, 1024, "a number up to 1024")},
      {"scratch", "DIR", group, "Directory for what does not fit into memory",
       text<Context>(&Context::scratch)}};
  return options;
}

}  // namespace winnow
