#include "decimate/nearest_lines.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace winnow {

std::vector<std::size_t> nearest_line_ends(std::span<const Point> seen) {
  struct End {
    double line = std::numeric_limits<double>::infinity();  // squares of distances
    double end = 0;
    std::size_t number = 0;
    bool operator<(const End& other) const {
      return std::tie(line, end, number) < std::tie(other.line, other.end, other.number);
    }
  };
  std::vector<End> ends(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) ends[i] = {ends[i].line, dot(seen[i], seen[i]), i};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t j = i + 1; j < seen.size(); ++j) {
      const Point along = seen[j] - seen[i];
      const Point twice_area = cross(seen[i], seen[j]);
      const double square = dot(along, along);
      if (!(square > 0)) continue;
      End& nearer = ends[ends[j].end < ends[i].end ? j : i];
      nearer.line = std::min(nearer.line, dot(twice_area, twice_area) / square);
    }
  }
  std::sort(ends.begin(), ends.end());
  std::vector<std::size_t> order;
  for (const End& end : ends) {
    if (end.line < std::numeric_limits<double>::infinity()) order.push_back(end.number);
  }
  return order;
}

}  // namespace winnow
