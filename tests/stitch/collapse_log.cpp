// One cost for all tiles: the cut is that of one sorted list, ties by tile.
#include "stitch/collapse_log.hpp"

#include "support/job.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cstring>
#include <tuple>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

struct Entry {
  double cost;
  std::size_t tile, number;
  std::uint64_t faces;  // that it alone removes
};

struct Logs {
  std::vector<std::vector<Collapse>> edges;
  std::vector<std::vector<CollapseLog::Cost>> costs;
  std::vector<Entry> sorted;
  std::uint64_t removed = 0;
};

Logs random_logs(Random& random, std::size_t tiles, std::size_t most, std::uint64_t kinds) {
  Logs logs;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    std::vector<Collapse> edges(random.below(most + 1));
    std::vector<CollapseLog::Cost> costs;
    double cost = 0;
    std::uint32_t removed = 0;
    const bool single = random.below(2) == 0;  // positions that floats have
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto place = static_cast<double>(i);
      edges[i].position = {place, -0.0, single ? place / 8 : place / 7};
      edges[i].kept = static_cast<VertexNumber>(random.below(1000));
      edges[i].removed = static_cast<VertexNumber>(1000 + i);
      cost += static_cast<double>(random.below(kinds)) / 16;
      const auto faces = static_cast<std::uint32_t>(random.between(1, 3));
      removed += faces;
      costs.push_back({cost, removed});
      logs.sorted.push_back({cost, tile, i, faces});
    }
    logs.removed += removed;
    logs.edges.push_back(std::move(edges));
    logs.costs.push_back(std::move(costs));
  }
  std::sort(logs.sorted.begin(), logs.sorted.end(), [](const Entry& a, const Entry& b) {
    return std::tuple(a.cost, a.tile, a.number) < std::tuple(b.cost, b.tile, b.number);
  });
  return logs;
}

}  // namespace

TEST_CASE("a cut takes the cheapest collapses of all tiles and no more") {
  Random random(870);
  for (const std::uint64_t kinds : {1, 2, 1000}) {
    for (const std::size_t tiles : {1, 3, 20}) {
      for (const std::size_t most : {0, 1, 200}) {
        const Logs logs = random_logs(random, tiles, most, kinds);
        TestJob test;
        // In memory, and in scratch.
        for (const std::uint64_t memory : {std::uint64_t{1} << 24, std::uint64_t{0}}) {
          CAPTURE(kinds, tiles, most, memory);
          CollapseLog log(test.job, memory);
          for (std::size_t t = 0; t < tiles; ++t) log.append(logs.edges[t], logs.costs[t]);
          log.finish();
          REQUIRE(log.removed() == logs.removed);
          for (int round = 0; round < 20; ++round) {
            const std::uint64_t wanted = round == 0 ? 0 : random.below(logs.removed + 3);
            std::vector<std::uint64_t> right(tiles, 0);
            std::uint64_t sum = 0;
            double cost = 0;
            for (const Entry& entry : logs.sorted) {
              if (sum >= wanted) break;
              sum += entry.faces;
              cost = entry.cost;
              ++right[entry.tile];
            }
            REQUIRE(log.cut(wanted) == right);
            if (sum >= wanted) REQUIRE(log.cost_of(wanted) == cost);
          }
          for (std::size_t t = 0; t < tiles; ++t) {
            const std::uint64_t count = random.below(logs.edges[t].size() + 1);
            const std::vector<Collapse> edges = log.edges(t, count);
            REQUIRE(edges.size() == count);
            for (std::size_t i = 0; i < count; ++i) {
              REQUIRE(edges[i].kept == logs.edges[t][i].kept);
              REQUIRE(edges[i].removed == logs.edges[t][i].removed);
              REQUIRE(std::memcmp(&edges[i].position, &logs.edges[t][i].position, sizeof(Point)) ==
                      0);
            }
          }
        }
      }
    }
  }
}

}  // namespace winnow
