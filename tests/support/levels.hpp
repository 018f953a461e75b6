// Runs with several targets.
#pragma once

#include <winnow/simplify.hpp>

#include "support/files.hpp"

#include <string>
#include <utility>
#include <vector>

namespace winnow::test {

inline SimplifyOptions to_levels(const std::vector<Target>& targets) {
  SimplifyOptions options;
  options.target = targets.front();
  options.coarser.assign(targets.begin() + 1, targets.end());
  return options;
}

// The same options with one of the targets alone.
inline SimplifyOptions level_of(SimplifyOptions options, std::size_t level) {
  if (level > 0) options.target = options.coarser[level - 1];
  options.coarser.clear();
  return options;
}

// Hashes of the files that the report tells of, which are removed.
inline std::vector<std::string> hashes_of_levels(const SimplifyReport& report) {
  std::vector<std::string> hashes;
  for (const LevelReport& level : report.levels) {
    hashes.push_back(hash_of_file(level.output.name));
    ::unlink(level.output.name.c_str());
  }
  return hashes;
}

}  // namespace winnow::test
