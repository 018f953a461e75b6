#include "decimate/carried_values.hpp"

#include <algorithm>

namespace winnow {

void CarriedValues::collapsed(const Collapse& edge) {
  if (attributes_ == 0) return;
  const Point& from = position_[edge.kept];
  const Point along = position_[edge.removed] - from;
  const double square = dot(along, along);
  const double part = square > 0 ? std::clamp(dot(edge.position - from, along) / square, 0.0, 1.0) : 0.5;
  double* kept = value_.data() + edge.kept * attributes_;
  const double* removed = value_.data() + edge.removed * attributes_;
  for (std::size_t i = 0; i < attributes_; ++i) kept[i] += part * (removed[i] - kept[i]);
  position_[edge.kept] = edge.position;
}

}  // namespace winnow
