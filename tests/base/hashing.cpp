// Hashes that tables and samples lean on.
#include "base/hash.hpp"
#include "base/wide.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a scaled hash is below its bound and rises with the hash") {
  test::Random random(10);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bound = std::max<std::uint64_t>(1, random.bits() >> random.below(64));
    const std::uint64_t a = random.bits();
    const std::uint64_t b = random.bits();
    REQUIRE(scaled_hash(a, bound) < bound);
    REQUIRE(scaled_hash(std::min(a, b), bound) <= scaled_hash(std::max(a, b), bound));
  }
  CHECK(scaled_hash(UINT64_MAX, 1) == 0);
  CHECK(scaled_hash(UINT64_MAX, UINT64_MAX) == UINT64_MAX - 1);
  CHECK(scaled_hash(0, 77) == 0);
}

TEST_CASE("consecutive keys spread evenly, by high bits and by low ones") {
  constexpr std::uint64_t keys = 1 << 16;
  std::array<int, 64> high{};
  std::array<int, 64> low{};
  std::set<std::uint64_t> seen;
  for (std::uint64_t key = 0; key < keys; ++key) {
    const std::uint64_t hash = mixed_hash(key);
    seen.insert(hash);
    ++high[scaled_hash(hash, 64)];
    ++low[hash & 63];
  }
  CHECK(seen.size() == keys);
  for (const auto& counts : {high, low}) {
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
    // 1024 each, give or take five standard deviations.
    CHECK(*least > 1024 - 160);
    CHECK(*most < 1024 + 160);
  }
}

TEST_CASE("any one bit of a key changes about half of its hash") {
  test::Random random(11);
  for (unsigned bit = 0; bit < 64; ++bit) {
    int changed = 0;
    for (int i = 0; i < 200; ++i) {
      const std::uint64_t key = random.bits();
      changed += std::popcount(mixed_hash(key) ^ mixed_hash(key ^ std::uint64_t{1} << bit));
    }
    CAPTURE(bit);
    CHECK(std::abs(changed / 200.0 - 32) < 3);
  }
}

}  // namespace winnow
