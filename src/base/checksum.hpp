// Tells whether bytes are still those that they were; no defence against malice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#define XXH_NAMESPACE winnow_  // other libraries may have theirs
#define XXH_STATIC_LINKING_ONLY
#include <xxhash.h>

namespace winnow {

// XXH64: as fast as memory is read.
class Checksum {
 public:
  Checksum() { XXH64_reset(&state_, 0); }

  // Content in parts of any sizes.
  void add(std::span<const std::byte> bytes) { XXH64_update(&state_, bytes.data(), bytes.size()); }
  [[nodiscard]] std::uint64_t value() const { return XXH64_digest(&state_); }

  static std::uint64_t of(std::span<const std::byte> bytes) {
    return XXH64(bytes.data(), bytes.size(), 0);
  }

 private:
  XXH64_state_t state_{};
};

}  // namespace winnow
