// Tells whether bytes are still those that they were; no defence against malice.
#pragma once

#include "base/hash.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace winnow {

// Four sums that do not wait for each other, as in xxHash: as fast as memory is read.
class Checksum {
 public:
  // Content may come in parts that are multiples of this, but for the last.
  static constexpr std::size_t stride = 32;

  void add(std::span<const std::byte> bytes) {
    size_ += bytes.size();
    for (; bytes.size() >= stride; bytes = bytes.subspan(stride)) mix(bytes.data());
    if (bytes.empty()) return;
    std::array<std::byte, stride> last{};  // the size tells zeros that were there from these
    std::memcpy(last.data(), bytes.data(), bytes.size());
    mix(last.data());
  }

  [[nodiscard]] std::uint64_t value() const {
    std::uint64_t sum = mixed_hash(size_);
    for (const std::uint64_t lane : lanes_) sum = mixed_hash(sum ^ lane);
    return sum;
  }

  static std::uint64_t of(std::span<const std::byte> bytes) {
    Checksum sum;
    sum.add(bytes);
    return sum.value();
  }

 private:
  void mix(const std::byte* bytes) {
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes + 8 * i, sizeof word);
      lanes_[i] = quick_hash(std::rotl(lanes_[i] ^ quick_hash(word), 31));
    }
  }

  std::array<std::uint64_t, 4> lanes_{1, 2, 3, 4};
  std::uint64_t size_ = 0;
};

}  // namespace winnow
