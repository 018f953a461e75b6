#include "decimate/volume_cost.hpp"

#include "decimate/best_fit_plane.hpp"
#include "decimate/hyperbolic.hpp"
#include "decimate/nearest_lines.hpp"
#include "decimate/solid_angle.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

// Of the origin from the line through two points.
double distance_to_line(const Point& a, const Point& b) {
  const Point along = b - a;
  const double size = length(along);
  return size > 0 ? length(cross(a, b)) / size : length(a);
}

}  // namespace

// The paper leaves borders open. A vertex there has the angle of its fan and of the fan's image in the
// border, so that one on a straight border of a flat part is as blunt as one inside; and it stands out as far
// as it does from the plane of its neighbours or from the line between the two along the border (Schroeder et
// al. 1992), for on a flat sheet the first is nothing even at a corner.
std::optional<CoveredVolume> covered_volume(std::span<const Point> seen, bool closed) {
  const std::optional<Point> ahead = supporting_direction(seen);
  if (!ahead) return std::nullopt;
  CoveredVolume covered;
  covered.angle = solid_angle_of_fan(seen, closed, *ahead);
  if (seen.size() > 2) covered.height = best_fit_plane(seen).distance({});
  if (!closed) {
    covered.angle *= 2;
    covered.height = std::max(covered.height, distance_to_line(seen.front(), seen.back()));
  }
  return covered;
}

VolumeCost::VolumeCost(TileMesh& mesh)
    : mesh_(mesh), angles_(mesh.vertex_count()), volume_(mesh.vertex_count(), 0) {
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    measure(v);
    changed_.clear();  // nothing is offered yet
  }
}

// Hyperbolic vertices stay, and those where the mesh is no surface: they have no volume and no part in the
// median.
void VolumeCost::measure(VertexNumber v) {
  changed_.push_back(v);
  if (!mesh_.locked(v) && fan_.find(mesh_, v)) {
    const std::optional<CoveredVolume> covered = covered_volume(fan_.seen(), fan_.closed());
    if (covered && std::isfinite(covered->volume())) {
      volume_[v] = std::max(volume_[v], covered->volume());
      angles_.set(v, covered->angle, [&](VertexNumber w) { changed_.push_back(w); });
      return;
    }
  }
  leave_out(v);
}

// Of the vertices whose angles are at least the median, which leaves the sharper half of the features alone.
// So the paper's text says; its program says larger than the median, and where most vertices are flat that
// leaves none.
Candidate VolumeCost::best(VertexNumber v, const Candidate& after) {
  if (!angles_.in_upper_half(v) || !fan_.find(mesh_, v)) return {};
  const std::span<const VertexNumber> ring = fan_.neighbours();
  // All of them have the price of the vertex. One at a border goes along that.
  bool found = after.price < 0;
  for (const std::size_t i : nearest_line_ends(fan_.seen())) {
    if (!fan_.closed() && i > 0 && i + 1 < ring.size()) continue;
    if (found && !mesh_.locked(ring[i])) return {volume_[v], ring[i]};
    found |= ring[i] == after.partner;
  }
  return {};
}

PricedCollapse VolumeCost::place(VertexNumber v, VertexNumber partner) const {
  return {{partner, v, mesh_.position(partner)}, volume_[v]};
}

void VolumeCost::collapsing(const PricedCollapse& now) {
  const auto ring = mesh_.neighbours(now.edge.removed);
  ring_.assign(ring.begin(), ring.end());
}

void VolumeCost::collapsed(const Collapse& edge, Offers& offers) {
  measure(edge.removed);
  for (const VertexNumber w : ring_) {
    volume_[w] = std::max(volume_[w], volume_[edge.removed]);
    measure(w);
  }
  offer_anew(offers);
}

// A vertex that cannot go has no part in the median until a neighbour changes: the upper half might be made
// of such vertices alone, while others wait.
void VolumeCost::gave_up(VertexNumber v, Offers& offers) {
  leave_out(v);
  offer_anew(offers);
}

void VolumeCost::leave_out(VertexNumber v) {
  angles_.erase(v, [&](VertexNumber w) { changed_.push_back(w); });
}

void VolumeCost::offer_anew(Offers& offers) {
  // More may change meanwhile.
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    const VertexNumber v = changed_[i];
    const Candidate candidate = best(v, Candidate::none_yet());
    offers.set(v, candidate);
    if (angles_.in_upper_half(v) && !candidate.exists()) leave_out(v);
  }
  changed_.clear();
}

}  // namespace winnow
