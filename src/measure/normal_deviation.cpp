#include "measure/normal_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace winnow {

void NormalDeviation::add(const Point& one, const Point& other) {
  if (one == Point{} || other == Point{}) return;
  const double degrees =
      std::atan2(length(cross(one, other)), dot(one, other)) * (180 / std::numbers::pi);
  if (!std::isfinite(degrees)) return;
  ++count_;
  degrees_.add(degrees);
  ++hundredths_[static_cast<std::size_t>(std::clamp(degrees * 100, 0.0, 18000.0))];
}

void NormalDeviation::merge(const NormalDeviation& more) {
  count_ += more.count_;
  degrees_.merge(more.degrees_);
  for (std::size_t i = 0; i < hundredths_.size(); ++i) hundredths_[i] += more.hundredths_[i];
}

CompareReport::Normals NormalDeviation::result() const {
  if (count_ == 0) return {};
  std::uint64_t seen = 0;
  std::size_t at = 0;
  while (seen * 20 < count_ * 19) seen += hundredths_[at++];
  return {degrees_.value() / static_cast<double>(count_),
          std::min(180.0, static_cast<double>(at) / 100)};
}

}  // namespace winnow
