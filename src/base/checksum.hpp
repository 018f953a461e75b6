// Tells whether bytes are still those that they were; no defence against malice.
#pragma once

#include "base/hash.hpp"

#include <algorithm>
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
  // Content in parts of any sizes.
  void add(std::span<const std::byte> bytes) {
    size_ += bytes.size();
    if (begun_ > 0) {
      const std::size_t length = std::min(bytes.size(), stride - begun_);
      std::memcpy(stretch_.data() + begun_, bytes.data(), length);
      begun_ += length;
      bytes = bytes.subspan(length);
      if (begun_ < stride) return;
      mix(lanes_, stretch_.data());
      begun_ = 0;
    }
    for (; bytes.size() >= stride; bytes = bytes.subspan(stride)) mix(lanes_, bytes.data());
    if (bytes.empty()) return;
    std::memcpy(stretch_.data(), bytes.data(), bytes.size());
    begun_ = bytes.size();
  }

  [[nodiscard]] std::uint64_t value() const {
    Lanes lanes = lanes_;
    if (begun_ > 0) {
      std::array<std::byte, stride> last{};  // the size tells zeros that were there from these
      std::memcpy(last.data(), stretch_.data(), begun_);
      mix(lanes, last.data());
    }
    std::uint64_t sum = mixed_hash(size_);
    for (const std::uint64_t lane : lanes) sum = mixed_hash(sum ^ lane);
    return sum;
  }

  static std::uint64_t of(std::span<const std::byte> bytes) {
    Checksum sum;
    sum.add(bytes);
    return sum.value();
  }

 private:
  static constexpr std::size_t stride = 32;
  using Lanes = std::array<std::uint64_t, 4>;

  static void mix(Lanes& lanes, const std::byte* bytes) {
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes + 8 * i, sizeof word);
      lanes[i] = quick_hash(std::rotl(lanes[i] ^ quick_hash(word), 31));
    }
  }

  Lanes lanes_{1, 2, 3, 4};
  std::uint64_t size_ = 0;
  std::array<std::byte, stride> stretch_{};  // begun, to be mixed when it is whole
  std::size_t begun_ = 0;
};

}  // namespace winnow
