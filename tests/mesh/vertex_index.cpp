// The vertices of a result, found by key and by number.
#include "mesh/vertex_index.hpp"

#include "support/job.hpp"
#include "support/random.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

std::vector<IndexedVertex> some_vertices(Random& random, std::size_t count, std::uint64_t keys) {
  std::vector<IndexedVertex> vertices(count);
  for (IndexedVertex& vertex : vertices) {
    // Dense, spread, or in clumps with gaps between.
    vertex.key = random.below(keys) << (random.chance(0.5) ? 0 : random.below(10));
    vertex.key = std::min<CellKey>(vertex.key, (CellKey{1} << 63) - 1);
    for (double& x : vertex.position) x = random.unit();
  }
  std::sort(vertices.begin(), vertices.end(),
            [](const auto& a, const auto& b) { return a.key < b.key; });
  vertices.erase(std::unique(vertices.begin(), vertices.end(),
                             [](const auto& a, const auto& b) { return a.key == b.key; }),
                 vertices.end());
  return vertices;
}

}  // namespace

TEST_CASE("vertices are found by key and number, in memory and in scratch") {
  Random random(520);
  for (const std::size_t count : {1, 2, 255, 256, 257, 5000, 100'000}) {
    for (const std::uint64_t keys : {std::uint64_t{1000}, std::uint64_t{200'000},
                                     std::uint64_t{1} << 40, std::uint64_t{1} << 53}) {
      const std::vector<IndexedVertex> vertices = some_vertices(random, count, keys);
      for (const std::uint64_t memory : {std::uint64_t{0}, std::uint64_t{64} << 20}) {
        TestJob here;
        VertexIndex index(here.job, memory);
        std::size_t at = 0;
        for (const std::size_t part : random.parts(vertices.size(), 3000)) {
          index.append(std::span(vertices).subspan(at, part));
          at += part;
        }
        index.finish();
        CAPTURE(count, keys, memory);
        REQUIRE(index.size() == vertices.size());
        REQUIRE(index.records().in_memory() == (memory > 0));
        VertexIndex::Reader reader(index);
        std::size_t number = 0;
        for (int i = 0; i < 3000; ++i) {
          // The same, one nearby, or any.
          if (random.chance(0.7))
            number = random.chance(0.5) ? random.below(vertices.size()) : number + random.below(5);
          number = std::min(number, vertices.size() - 1);
          const auto& found = reader.find(vertices[number].key);
          REQUIRE(found.number == number);
          REQUIRE(found.vertex.key == vertices[number].key);
          REQUIRE(found.vertex.position == vertices[number].position);
          REQUIRE(reader.at(number).position == vertices[number].position);
        }
        for (const std::size_t end : {std::size_t{0}, vertices.size() - 1})
          REQUIRE(reader.find(vertices[end].key).number == end);
      }
    }
  }
}

TEST_CASE("vertices that share a key are found by their position, or not at all") {
  Random random(521);
  for (const std::uint64_t keys : {1, 3, 2000}) {
    std::vector<IndexedVertex> vertices(20'000);
    for (IndexedVertex& vertex : vertices) {
      vertex.key = 7 * random.below(keys);
      for (double& x : vertex.position) x = random.unit();
    }
    std::sort(vertices.begin(), vertices.end(), [](const auto& a, const auto& b) {
      return a.key != b.key ? a.key < b.key : a.position < b.position;
    });
    for (const std::uint64_t memory : {std::uint64_t{0}, std::uint64_t{64} << 20}) {
      CAPTURE(keys, memory);
      TestJob here;
      VertexIndex index(here.job, memory);
      index.append(vertices);
      index.finish();
      VertexIndex::Reader reader(index);
      for (std::size_t number = 0; number < vertices.size(); number += 1 + random.below(20)) {
        const auto& [key, position, normal, unused] = vertices[number];
        REQUIRE(reader.find(key, position) == number);
        REQUIRE(reader.find(key, position) == number);
        for (const double off : {-1e-9, 1e-9, 2.0, -2.0})
          REQUIRE(reader.find(key, {position[0] + off, position[1], position[2]}) == reader.absent);
        REQUIRE(reader.find(key + 1, position) == reader.absent);
      }
    }
  }
}

TEST_CASE("an index of nothing is empty") {
  TestJob here;
  VertexIndex index(here.job, 1 << 20);
  index.finish();
  CHECK(index.size() == 0);
  CHECK_NOTHROW(VertexIndex::Reader(index));
}

}  // namespace winnow
