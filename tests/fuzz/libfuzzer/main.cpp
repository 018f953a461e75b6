// One target under libFuzzer: WINNOW_FUZZ_TARGET names it.
#include "fuzz/targets.hpp"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const winnow::fuzz::Target& target = winnow::fuzz::target_called(WINNOW_FUZZ_TARGET);
  target.run(std::as_bytes(std::span(bytes, size)));
  return 0;
}
