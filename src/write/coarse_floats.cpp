#include "write/coarse_floats.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winnow {

void note_coarse_floats(Job& job, const Box& box, std::uint64_t faces) {
  if (box.empty || faces == 0) return;
  double farthest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    farthest = std::max({farthest, std::abs(box.low[axis]), std::abs(box.high[axis])});
  const auto single = static_cast<float>(std::min<double>(farthest, std::numeric_limits<float>::max()));
  const double step = std::nextafter(single, std::numeric_limits<float>::infinity()) - single;
  const double edge = box.longest_side() / std::sqrt(static_cast<double>(faces));  // roughly
  if (!(step * 16 > edge)) return;
  job.note("floats step by " + shortest(step) +
           " this far from the origin: vertices move, some may fall together; PLY with doubles and GLB keep "
           "them apart");
}

}  // namespace winnow
