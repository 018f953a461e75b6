// Kernels that are compiled once for each instruction set.
#pragma once

#include "base/instruction_set.hpp"

#include <string>
#include <utility>
#include <vector>

namespace winnow::test {

// Those of three that this processor runs, with their names, the baseline first.
template <typename Kernel>
std::vector<std::pair<std::string, Kernel>> runnable(Kernel baseline, Kernel avx2, Kernel avx512) {
  std::vector<std::pair<std::string, Kernel>> kernels{{"baseline", baseline}};
  const InstructionSet widest = widest_instruction_set();
  if (widest != InstructionSet::baseline) kernels.emplace_back("avx2", avx2);
  if (widest == InstructionSet::avx512) kernels.emplace_back("avx512", avx512);
  return kernels;
}

}  // namespace winnow::test
