// The widest vector instructions that this processor runs, of those that kernels are compiled for
// (src/CMakeLists.txt).
#pragma once

namespace winnow {

enum class InstructionSet { baseline, avx2, avx512 };

InstructionSet widest_instruction_set();

// Of three kernels the one for this processor.
template <typename Kernel>
Kernel best_kernel(Kernel baseline, Kernel avx2, Kernel avx512) {
  switch (widest_instruction_set()) {
    case InstructionSet::avx512:
      return avx512;
    case InstructionSet::avx2:
      return avx2;
    case InstructionSet::baseline:
      break;
  }
  return baseline;
}

}  // namespace winnow
