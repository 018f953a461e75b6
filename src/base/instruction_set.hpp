// The widest vector instructions that this processor runs, of those that kernels are compiled for
// (src/CMakeLists.txt).
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

namespace winnow {

enum class InstructionSet { baseline, avx2, avx512 };

InstructionSet widest_instruction_set();

// What a kernel is called, compiled for each of them; on other machines than x86-64 there is no
// choice.
#if defined(__x86_64__)
#define WINNOW_KERNELS(kernel) kernel##_baseline, kernel##_avx2, kernel##_avx512
#else
#define WINNOW_KERNELS(kernel) kernel##_baseline
#endif

// Of WINNOW_KERNELS the one for this processor.
template <typename Kernel, std::same_as<Kernel>... Wider>
Kernel best_kernel(Kernel baseline, Wider... wider) {
  return std::array{baseline, wider...}[static_cast<std::size_t>(widest_instruction_set())];
}

}  // namespace winnow
