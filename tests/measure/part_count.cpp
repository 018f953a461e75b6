// Connected parts are counted right, also where the table was emptied again and again.
#include "measure/part_count.hpp"

#include "base/hash.hpp"
#include "io/arena.hpp"
#include "support/job.hpp"

#include <numeric>
#include <random>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

using HashedFace = std::array<std::uint64_t, 3>;

// By hand: each face joins its three corners.
std::uint64_t parts_by_hand(const std::vector<HashedFace>& faces, std::size_t points) {
  std::vector<std::size_t> parent(points);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::set<std::size_t> used;
  for (const auto& [a, b, c] : faces) {
    parent[root(a)] = root(b);
    parent[root(b)] = root(c);
  }
  for (const HashedFace& face : faces) used.insert(root(face[0]));
  return used.size();
}

std::uint64_t parts_counted(const std::vector<HashedFace>& faces, std::uint64_t memory,
                            bool in_order, std::optional<std::uint64_t> positions) {
  test::TestJob test;
  return in_arena(test.job, [&] {
    PartCount parts(test.job, memory, positions);
    std::vector<HashedFace> hashed;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const HashedFace& face = faces[in_order ? i : i * 7919 % faces.size()];
      hashed.push_back({mixed_hash(face[0]), mixed_hash(face[1]), mixed_hash(face[2])});
      if (hashed.size() < PartCount::most_at_once && i + 1 < faces.size()) continue;
      parts.add(hashed);
      hashed.clear();
    }
    return parts.finish();
  });
}

}  // namespace

TEST_CASE("connected parts are counted whatever the memory, the order and what is known before",
          "[slow][long]") {
  std::mt19937 random(1);
  constexpr std::size_t points = 200'003;
  std::vector<HashedFace> strips;  // of very different lengths, apart from each other
  for (std::size_t begin = 0; begin + 3 < points;) {
    const std::size_t length = std::min<std::size_t>(points - begin - 1, 3 + random() % 5000);
    for (std::size_t i = begin; i + 2 < begin + length; ++i) strips.push_back({i, i + 1, i + 2});
    begin += length;
  }
  std::vector<HashedFace>
      scattered;  // about as many faces as points: one large part and many small ones
  for (std::size_t i = 0; i < points / 2; ++i)
    scattered.push_back({random() % points, random() % points, random() % points});
  for (const std::vector<HashedFace>& faces : {strips, scattered}) {
    const std::uint64_t parts = parts_by_hand(faces, points);
    REQUIRE(parts > 10);
    for (const std::uint64_t memory : {std::uint64_t{1} << 20, std::uint64_t{64} << 20}) {
      for (const bool in_order : {true, false}) {
        CAPTURE(memory, in_order);
        CHECK(parts_counted(faces, memory, in_order, {}) == parts);
        CHECK(parts_counted(faces, memory, in_order, points) == parts);
      }
    }
  }
}

TEST_CASE("a surface without faces has no parts, and a face in one place is none") {
  CHECK(parts_counted({}, std::uint64_t{1} << 20, true, {}) == 0);
  CHECK(parts_counted({{5, 5, 5}}, std::uint64_t{1} << 20, true, {}) == 0);
  CHECK(parts_counted({{5, 5, 6}}, std::uint64_t{1} << 20, true, {}) == 1);
}

}  // namespace winnow
