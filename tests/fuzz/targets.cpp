#include "fuzz/targets.hpp"

#include <cstdio>
#include <cstdlib>

namespace winnow::fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> all{{"mesh", read_mesh},       {"spill", read_spill},
                                       {"journal", read_journal}, {"manifest", read_manifest},
                                       {"decimate", decimate},    {"progressive", play}};
  return all;
}

const Target& target_called(const std::string& name) {
  for (const Target& target : targets()) {
    if (name == target.name) return target;
  }
  std::fprintf(stderr, "no target is called %s\n", name.c_str());
  std::abort();
}

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

}  // namespace winnow::fuzz
