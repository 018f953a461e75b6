#include "sequence/vertex_order.hpp"

#include "base/box.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

namespace winnow {

namespace {

// Of the cell that holds it.
class KeyOfPlace {
 public:
  explicit KeyOfPlace(const std::vector<Point>& positions) {
    for (const Point& p : positions) {
      if (finite(p)) box_.add(p);
    }
    const double side = box_.empty ? 0 : box_.longest_side();
    cells_ = side > 0 ? (axis_cells - 1) / side : 0;
  }

  CellKey operator()(const Point& p) const {
    if (!finite(p)) return 0;
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double place = std::max(0.0, (p[axis] - box_.low[axis]) * cells_);
      cell[axis] = std::min(axis_cells - 1, static_cast<std::uint32_t>(place));
    }
    return morton_key(cell[0], cell[1], cell[2]);
  }

 private:
  Box box_;
  double cells_;
};

}  // namespace

VertexOrder order_by_place(Job& job, const std::vector<Point>& positions,
                           std::vector<CellKey>& keys) {
  const std::size_t count = positions.size();
  const KeyOfPlace key_of(positions);
  keys.resize(count);
  for (std::size_t v = 0; v < count; ++v) keys[v] = key_of(positions[v]);
  VertexOrder order;
  order.input.resize(count);
  std::iota(order.input.begin(), order.input.end(), 0U);
  std::sort(order.input.begin(), order.input.end(),
            job.progress.cancellable([&](std::uint32_t a, std::uint32_t b) {
              if (keys[a] != keys[b]) return keys[a] < keys[b];
              const bool numbers = finite(positions[a]) && finite(positions[b]);
              if (numbers && positions[a] != positions[b]) return positions[a] < positions[b];
              if (!numbers && finite(positions[a]) != finite(positions[b]))
                return finite(positions[a]);
              return a < b;
            }));
  order.key.resize(count);
  order.place.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    order.key[i] = keys[order.input[i]];
    order.place[order.input[i]] = static_cast<std::uint32_t>(i);
  }
  return order;
}

void put_in_order(std::vector<Point>& positions, const VertexOrder& order) {
  // Each cycle of the permutation.
  std::vector<bool> moved(positions.size(), false);
  for (std::size_t start = 0; start < positions.size(); ++start) {
    if (moved[start]) continue;
    Point carried = positions[start];
    for (std::size_t at = order.place[start]; !moved[at]; at = order.place[at]) {
      std::swap(carried, positions[at]);
      moved[at] = true;
    }
  }
}

}  // namespace winnow
