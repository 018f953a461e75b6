#include "decimate/carried_values.hpp"

#include <algorithm>

namespace winnow {

namespace {

// How much of the middle of the edge there is beside the place nearest to the vertex. By measurement
// (src/DESIGN.md): 0 is best for what varies smoothly, 1 evens out the noise of colours best; one half is
// nearly as good at either.
constexpr double middle = 0.5;

}  // namespace

void CarriedValues::collapsed(const Collapse& edge) {
  if (attributes_ == 0 || edge.of_piece()) return;
  const Point& from = position_[edge.kept];
  const Point along = position_[edge.removed] - from;
  const double square = dot(along, along);
  const double nearest = square > 0 ? std::clamp(dot(edge.position - from, along) / square, 0.0, 1.0) : 0.5;
  const double part = (1 - middle) * nearest + middle * 0.5;
  double* kept = value_.data() + edge.kept * attributes_;
  const double* removed = value_.data() + edge.removed * attributes_;
  for (std::size_t i = 0; i < attributes_; ++i) kept[i] += part * (removed[i] - kept[i]);
  position_[edge.kept] = edge.position;
}

}  // namespace winnow
