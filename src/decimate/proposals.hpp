// The edges that vertices propose, by what they cost: the cheapest first, nearly.
#pragma once

#include "base/vector.hpp"
#include "decimate/cost_classes.hpp"
#include "decimate/tile_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

// What collapsing an edge costs and where it goes to.
struct EvaluatedEdge {
  double cost = std::numeric_limits<double>::infinity();
  Point position{};
  VertexNumber high = no_number;
  bool flat_low = false, flat_high = false;  // nothing is lost at this end but rounding
};

// Every vertex proposes one edge: of those to higher numbers the cheapest.
class Proposals {
 public:
  explicit Proposals(VertexNumber vertices) : of_(vertices), counts_(cost_classes) {}

  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    return vertices * (sizeof(EvaluatedEdge) + sizeof(VertexNumber));
  }

  void clear(VertexNumber v) { of_[v] = {}; }
  // Costs are not below 0. Of equally cheap ones the first stays.
  void add(VertexNumber low, const EvaluatedEdge& edge) {
    if (edge.cost < of_[low].cost) of_[low] = edge;
  }
  [[nodiscard]] const EvaluatedEdge& of(VertexNumber v) const { return of_[v]; }

  // How many of these vertices propose one.
  std::size_t count(std::span<const VertexNumber> vertices) {
    std::fill(counts_.begin(), counts_.end(), 0);
    std::size_t count = 0;
    for (const VertexNumber v : vertices) {
      if (!proposes(v)) continue;
      ++counts_[cost_class(of_[v].cost)];
      ++count;
    }
    return count;
  }

  struct Cheapest {
    std::span<const VertexNumber> vertices;
    double bound = 0;  // none of them costs as much
  };
  // Of the counted ones so many, and those that cost nearly as much as the last: cheaper classes
  // first, those of `alike` classes, counted from the costliest, in the order of the vertices.
  // Beyond `usual` of them none that costs more than `factor` times as much. Once for each count().
  Cheapest cheapest(std::span<const VertexNumber> vertices, std::size_t wanted, std::size_t usual,
                    double factor, std::uint32_t alike) {
    std::uint32_t end = 0;
    std::uint32_t count = 0;
    std::uint32_t last = cost_classes;
    for (; end < last && count < wanted; ++end) {
      count += std::exchange(counts_[end], count);
      if (count < usual || last < cost_classes || end + 1 == cost_classes) continue;
      last = std::max(end + 1, cost_class(factor * least_of_cost_class(end + 1)));
    }
    sorted_.resize(count);
    for (const VertexNumber v : vertices) {
      if (!proposes(v)) continue;
      const std::uint32_t its = cost_class(of_[v].cost);
      if (its >= end) continue;
      const std::uint32_t from_end = (end - 1 - its) / alike * alike;
      sorted_[counts_[end - std::min(end, from_end + alike)]++] = v;
    }
    if (end == cost_classes) return {sorted_, std::numeric_limits<double>::infinity()};
    return {sorted_, least_of_cost_class(end)};
  }

 private:
  [[nodiscard]] bool proposes(VertexNumber v) const { return std::isfinite(of_[v].cost); }

  std::vector<EvaluatedEdge> of_;
  std::vector<std::uint32_t> counts_;
  std::vector<VertexNumber> sorted_;
};

}  // namespace winnow
