#include "write/coarse_floats.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace winnow {

namespace {

// About as long as an edge is.
double edge_length(const Box& box, std::uint64_t faces) {
  return box.longest_side() / std::sqrt(static_cast<double>(faces));
}

}  // namespace

void note_coarse_floats(Job& job, const Box& box, std::uint64_t faces) {
  if (box.empty || faces == 0) return;
  double farthest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    farthest = std::max({farthest, std::abs(box.low[axis]), std::abs(box.high[axis])});
  const auto single =
      static_cast<float>(std::min<double>(farthest, std::numeric_limits<float>::max()));
  const double step = std::nextafter(single, std::numeric_limits<float>::infinity()) - single;
  if (!(step * 16 > edge_length(box, faces))) return;
  job.note("floats step by " + shortest(step) +
           " this far from the origin: vertices move, some may fall together; PLY with doubles and "
           "GLB keep "
           "them apart");
}

void note_coarse_steps(Job& job, const Box& box, std::uint64_t faces, double error) {
  if (box.empty || faces == 0 || !(error * 4 > edge_length(box, faces))) return;
  std::array<char, 32> text{};
  const auto [end, failed] =
      std::to_chars(text.data(), text.data() + text.size(), error, std::chars_format::general, 3);
  job.note("quantized positions move by up to " + std::string(text.data(), end) +
           ", much beside the edges: some vertices may fall together; more bits keep them apart");
}

void check_floats(const Box& box) {
  constexpr double most = std::numeric_limits<float>::max();
  for (const Point& corner : {box.low, box.high}) {
    for (const double value : corner) {
      if (std::abs(value) <= most) continue;
      throw Error(ErrorKind::usage, "the output holds floats, too small for coordinates like " +
                                        shortest(value) +
                                        "; ask for PLY, OBJ, OFF or .m with doubles");
    }
  }
}

}  // namespace winnow
