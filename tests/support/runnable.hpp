// Kernels that are compiled once for each instruction set.
#pragma once

#include "base/instruction_set.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace winnow::test {

// Those of WINNOW_KERNELS that this processor runs, with their names, the baseline first.
template <typename Kernel, typename... Wider>
std::vector<std::pair<std::string, Kernel>> runnable(Kernel baseline, Wider... wider) {
  const std::array<Kernel, 1 + sizeof...(wider)> compiled{baseline, wider...};
  const std::array<const char*, 3> names{"baseline", "avx2", "avx512"};
  std::vector<std::pair<std::string, Kernel>> kernels;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(widest_instruction_set()); ++i)
    kernels.emplace_back(names.at(i), compiled.at(i));
  return kernels;
}

}  // namespace winnow::test
