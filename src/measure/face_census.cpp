#include "measure/face_census.hpp"

#include "base/edge_hash.hpp"
#include "read/good_faces.hpp"

#include <cmath>

namespace winnow {

FaceCensus::FaceCensus(Job& job, const Memory& memory, const Point& origin,
                       std::optional<std::uint64_t> positions)
    : origin_(origin),
      parts_(job.threads, [origin] { return std::make_unique<Part>(origin); }),
      edges_(job, memory.edges),
      connected_(job, memory.parts, positions) {}

void FaceCensus::add_point(Part& part, const Point& point) {
  if (finite(point)) part.box.add(point);
}

void FaceCensus::add_positions(const PositionView& view) {
  Part& part = parts_.local();
  for (std::size_t i = 0; i < view.count; ++i)
    add_point(part, {view.axis[0][i], view.axis[1][i], view.axis[2][i]});
}

void FaceCensus::add_corners(const FaceBatch& faces) {
  Part& part = parts_.local();
  for (std::size_t i = 0; i < faces.count; ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) add_point(part, faces.corner(corner, i));
  }
}

void FaceCensus::add_faces(const FaceBatch& faces) {
  Part& part = parts_.local();
  std::array<std::uint64_t, 3 * FaceBatch::capacity> sides;
  std::array<std::array<std::uint64_t, 3>, FaceBatch::capacity> corners;
  std::size_t kept = 0, joined = 0;
  part.faces += faces.count;
  const GoodFaces good(faces);
  part.bad.add(good.bad());
  for (const auto& [p, number] : good.faces()) {
    part.zero_area += length(doubled_area(p)) == 0 ? 1 : 0;
    part.totals.add(p);
    std::array<std::uint64_t, 3>& end = corners[joined++];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const double side = length(p[corner] - p[(corner + 1) % 3]);
      // Coordinates near the end of a double's range have lengths beyond it.
      if (std::isfinite(side)) part.edge_lengths.add(side);
      ++part.sides;
      end[corner] = position_hash(p[corner]);
    }
    for (std::size_t corner = 0; corner < 3; ++corner)
      sides[kept++] = edge_hash(end[corner], end[(corner + 1) % 3]);
  }
  edges_.add({sides.data(), kept});
  connected_.add({corners.data(), joined});
}

InfoReport FaceCensus::finish() {
  Part all(origin_);
  for (const Part* part : parts_.all()) {
    all.faces += part->faces;
    all.zero_area += part->zero_area;
    all.sides += part->sides;
    all.bad.add(part->bad);
    all.totals.merge(part->totals);
    all.edge_lengths.merge(part->edge_lengths);
    all.box.add(part->box);
  }
  InfoReport report;
  report.faces = all.faces;
  report.bad_faces = all.bad;
  report.zero_area = all.zero_area;
  if (!all.box.empty) report.box = {all.box.low, all.box.high};
  report.area = all.totals.area();
  report.mean_edge = all.sides == 0 ? 0 : all.edge_lengths.value() / static_cast<double>(all.sides);
  report.edges = edges_.finish();
  report.watertight =
      report.edges.total > 0 && report.edges.boundary == 0 && report.edges.non_manifold == 0;
  report.parts = connected_.finish();
  if (all.totals.closed()) report.volume = all.totals.volume();
  return report;
}

}  // namespace winnow
