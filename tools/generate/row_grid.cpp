#include "generate/row_grid.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

RowGrid nearest_grid(std::uint64_t count, double proportion, RowGrid smallest) {
  // Edges of one direction may become this much longer or shorter to meet the count.
  constexpr double leeway = 1.4;
  constexpr std::uint64_t most_tries = std::uint64_t{1} << 17;

  const auto ideal = std::max(
      smallest.columns,
      static_cast<std::uint64_t>(std::sqrt(static_cast<double>(count) * proportion) + 0.5));
  const std::uint64_t reach = std::min(
      static_cast<std::uint64_t>(static_cast<double>(ideal) * (leeway - 1)) + 2, most_tries);
  RowGrid best;
  std::uint64_t best_miss = UINT64_MAX;
  const auto consider = [&](std::uint64_t columns) {
    const std::uint64_t rows = std::max(smallest.rows, (count + columns / 2) / columns);
    const std::uint64_t made = columns * rows;
    const std::uint64_t miss = made > count ? made - count : count - made;
    if (miss < best_miss) {
      best_miss = miss;
      best = {columns, rows};
    }
  };
  for (std::uint64_t away = 0; away <= reach && best_miss != 0; ++away) {
    consider(ideal + away);
    if (best_miss != 0 && ideal >= smallest.columns + away) consider(ideal - away);
  }
  return best;
}

}  // namespace winnow
