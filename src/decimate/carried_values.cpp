#include "decimate/carried_values.hpp"

#include <algorithm>

namespace winnow {

namespace {

// How much of the middle of the edge there is beside the place nearest to the vertex. By
// measurement (docs/design/attributes.md): 0 is best for what varies smoothly, 1 evens out the
// noise of colours best; one half is nearly as good at either.
constexpr double middle = 0.5;

}  // namespace

void CarriedValues::collapsed(const Collapse& edge) {
  if (attributes_.empty() || edge.of_piece()) return;
  // A hub of another tile keeps what it carries, which is not known here.
  if (edge.kept >= position_.size()) return;
  const Point& from = position_[edge.kept];
  const Point along = position_[edge.removed] - from;
  const double square = dot(along, along);
  const double nearest =
      square > 0 ? std::clamp(dot(edge.position - from, along) / square, 0.0, 1.0) : 0.5;
  const double part = (1 - middle) * nearest + middle * 0.5;
  double* kept = value_.data() + edge.kept * attributes_.size();
  const double* removed = value_.data() + edge.removed * attributes_.size();
  for (std::size_t i = 0; i < attributes_.size(); ++i) {
    const Attribute& attribute = attributes_[i];
    if (attribute.lacks(removed[i])) continue;
    if (attribute.lacks(kept[i])) {
      kept[i] = removed[i];
    } else if (attribute.kind == AttributeKind::label) {
      if (part > 0.5 || (part == 0.5 && removed[i] < kept[i])) kept[i] = removed[i];
    } else {
      kept[i] += part * (removed[i] - kept[i]);
    }
  }
  position_[edge.kept] = edge.position;
}

}  // namespace winnow
