#include "stitch/collapse_log.hpp"

#include "base/memory_shares.hpp"
#include "base/search.hpp"
#include "base/vector.hpp"
#include "decimate/cost_classes.hpp"
#include "io/spool_records.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>

namespace winnow {

namespace {

// One whose position floats have.
struct SingleCollapse {
  VertexNumber kept, removed;
  std::array<float, 3> position;
};
constexpr std::size_t at_once = 256;

bool is_single(const Collapse& edge) {
  return std::all_of(edge.position.begin(), edge.position.end(), [](double x) {
    return std::bit_cast<std::uint64_t>(nearest_float(x)) == std::bit_cast<std::uint64_t>(x);
  });
}
SingleCollapse halved(const Collapse& edge) {
  const auto [x, y, z] = edge.position;
  return {edge.kept,
          edge.removed,
          {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}};
}
Collapse doubled(const SingleCollapse& edge) {
  const auto [x, y, z] = edge.position;
  return {edge.kept, edge.removed, {x, y, z}};
}

}  // namespace

CollapseLog::CollapseLog(Job& job, std::uint64_t memory)
    : edges_(job, share::refine::edges(memory)),
      costs_(job, share::refine::costs(memory)),
      removed_in_class_(cost_classes) {}

void CollapseLog::append(const std::vector<Collapse>& edges, const std::vector<Cost>& costs) {
  const bool single = std::all_of(edges.begin(), edges.end(), is_single);
  edges_of_.push_back({edges_.size(), single});
  if (single) {
    std::array<SingleCollapse, at_once> chunk{};
    for (std::size_t at = 0; at < edges.size(); at += at_once) {
      const std::size_t count = std::min(at_once, edges.size() - at);
      for (std::size_t i = 0; i < count; ++i) chunk[i] = halved(edges[at + i]);
      append_records<SingleCollapse>(edges_, std::span(chunk).first(count));
    }
  } else {
    append_records<Collapse>(edges_, edges);
  }
  append_records<Cost>(costs_, costs);
  first_.push_back(first_.back() + costs.size());
  std::uint64_t before = 0;
  for (const Cost& entry : costs) {
    removed_in_class_[cost_class(entry.cost)] += entry.removed - before;
    before = entry.removed;
  }
}

void CollapseLog::finish() {
  edges_.finish();
  costs_.finish();
}

CollapseLog::Cost CollapseLog::at(std::uint64_t entry) const {
  return read_record<Cost>(costs_, entry);
}

std::uint64_t CollapseLog::count(std::size_t tile, double cost, bool with_equal,
                                 Range among) const {
  const std::uint64_t first = first_[tile];
  const auto counts = [&](std::uint64_t entry) {
    const double found = at(entry).cost;
    return found < cost || (with_equal && found == cost);
  };
  return first_not_before(first + among.least, first + among.most, counts) - first;
}

std::uint64_t CollapseLog::removed_by(std::size_t tile, std::uint64_t count) const {
  return count == 0 ? 0 : at(first_[tile] + count - 1).removed;
}

std::uint64_t CollapseLog::removed() const {
  std::uint64_t sum = 0;
  for (std::size_t tile = 0; tile < tiles(); ++tile) sum += removed_by(tile, entries(tile));
  return sum;
}

double CollapseLog::cost_of(std::uint64_t faces) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::size_t number = 0;
  for (std::uint64_t sum = 0; number < cost_classes; ++number) {
    sum += removed_in_class_[number];
    if (sum >= faces) break;
  }
  if (number > cost_class(infinite)) return infinite;
  // Numbers not below 0 are in the order of their bits.
  std::uint64_t low = std::bit_cast<std::uint64_t>(least_of_cost_class(number));
  std::uint64_t high = std::bit_cast<std::uint64_t>(least_of_cost_class(number + 1)) - 1;
  high = std::min(high, std::bit_cast<std::uint64_t>(infinite));
  // Collapses of each tile that such costs reach: as they close in, there is less to look at.
  std::vector<std::uint64_t> least(tiles()), most(tiles()), removed(tiles());
  for (std::size_t tile = 0; tile < tiles(); ++tile) {
    least[tile] = count(tile, std::bit_cast<double>(low), false);
    most[tile] = count(tile, std::bit_cast<double>(high), true, {least[tile], entries(tile)});
    removed[tile] = removed_by(tile, most[tile]);
  }
  std::vector<std::uint64_t> counts = most, removed_now = removed;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    std::uint64_t sum = 0;
    for (std::size_t tile = 0; tile < tiles(); ++tile) {
      counts[tile] = most[tile];
      removed_now[tile] = removed[tile];
      if (least[tile] < most[tile]) {
        counts[tile] = count(tile, std::bit_cast<double>(middle), true, {least[tile], most[tile]});
        removed_now[tile] = removed_by(tile, counts[tile]);
      }
      sum += removed_now[tile];
    }
    if (sum < faces) {
      low = middle + 1;
      least = counts;
    } else {
      high = middle;
      most = counts;
      removed = removed_now;
    }
  }
  return std::bit_cast<double>(low);
}

std::vector<std::uint64_t> CollapseLog::cut(std::uint64_t faces) const {
  const double cost = cost_of(faces);
  std::vector<std::uint64_t> counts(tiles());
  std::uint64_t sum = 0;
  for (std::size_t tile = 0; tile < tiles(); ++tile) {
    counts[tile] = count(tile, cost, false);
    sum += removed_by(tile, counts[tile]);
  }
  for (std::size_t tile = 0; tile < tiles(); ++tile) {
    const std::uint64_t end = count(tile, cost, true);
    while (sum < faces && counts[tile] < end) {
      const std::uint64_t before = removed_by(tile, counts[tile]);
      sum += removed_by(tile, ++counts[tile]) - before;
    }
  }
  return counts;
}

std::vector<std::uint64_t> CollapseLog::up_to(double cost) const {
  std::vector<std::uint64_t> counts;
  for (std::size_t tile = 0; tile < tiles(); ++tile) counts.push_back(count(tile, cost, true));
  return counts;
}

std::vector<std::uint64_t> CollapseLog::all() const {
  std::vector<std::uint64_t> counts;
  for (std::size_t tile = 0; tile < tiles(); ++tile) counts.push_back(entries(tile));
  return counts;
}

double CollapseLog::error(std::size_t tile, std::uint64_t count) const {
  return count == 0 ? 0 : at(first_[tile] + count - 1).error;
}

std::vector<Collapse> CollapseLog::edges(std::size_t tile, std::uint64_t count) const {
  const auto [begin, single] = edges_of_[tile];
  std::vector<Collapse> edges(count);
  if (!single) {
    edges_.read(begin, std::as_writable_bytes(std::span(edges)));
    return edges;
  }
  std::array<SingleCollapse, at_once> chunk{};
  for (std::uint64_t at = 0; at < count; at += at_once) {
    const std::span<SingleCollapse> some =
        std::span(chunk).first(std::min<std::uint64_t>(at_once, count - at));
    edges_.read(begin + at * sizeof(SingleCollapse), std::as_writable_bytes(some));
    for (std::size_t i = 0; i < some.size(); ++i) edges[at + i] = doubled(some[i]);
  }
  return edges;
}

std::vector<CollapseLog::Cost> CollapseLog::costs(std::size_t tile) const {
  return read_records<Cost>(costs_, first_[tile], entries(tile));
}

}  // namespace winnow
