#include "measure/face_census.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

using Point = std::array<double, 3>;

bool finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double length(const Point& p) {
  return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
}

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

FaceCensus::FaceCensus(Job& job, std::uint64_t edge_memory)
    : parts_(job.threads, [] { return std::make_unique<Part>(); }), edges_(job, edge_memory) {}

void FaceCensus::add_point(Part& part, const Point& point) {
  if (!finite(point)) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    part.low[axis] = part.has_box ? std::min(part.low[axis], point[axis]) : point[axis];
    part.high[axis] = part.has_box ? std::max(part.high[axis], point[axis]) : point[axis];
  }
  part.has_box = true;
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
  std::size_t kept = 0;
  part.faces += faces.count;
  for (std::size_t i = 0; i < faces.count; ++i) {
    const std::array<Point, 3> p{faces.corner(0, i), faces.corner(1, i), faces.corner(2, i)};
    if (faces.status[i] == FaceStatus::out_of_range) {
      ++part.bad.out_of_range;
    } else if (faces.status[i] == FaceStatus::good && !(finite(p[0]) && finite(p[1]) && finite(p[2]))) {
      ++part.bad.non_finite;
    } else if (faces.status[i] != FaceStatus::good || p[0] == p[1] || p[0] == p[2] || p[1] == p[2]) {
      ++part.bad.degenerate;
    } else {
      const double area = length(cross(difference(p[1], p[0]), difference(p[2], p[0]))) / 2;
      part.zero_area += area == 0 ? 1 : 0;
      // Coordinates near the end of a double's range have lengths beyond it.
      if (std::isfinite(area)) part.area.add(area);
      std::array<std::uint64_t, 3> end{};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const double side = length(difference(p[corner], p[(corner + 1) % 3]));
        if (std::isfinite(side)) part.edge_lengths.add(side);
        ++part.sides;
        end[corner] = EdgeCount::hash_position(p[corner]);
      }
      for (std::size_t corner = 0; corner < 3; ++corner)
        sides[kept++] = EdgeCount::hash_edge(end[corner], end[(corner + 1) % 3]);
    }
  }
  edges_.add({sides.data(), kept});
}

InfoReport FaceCensus::finish() {
  Part all;
  for (const Part* part : parts_.all()) {
    all.faces += part->faces;
    all.zero_area += part->zero_area;
    all.sides += part->sides;
    all.bad.degenerate += part->bad.degenerate;
    all.bad.non_finite += part->bad.non_finite;
    all.bad.out_of_range += part->bad.out_of_range;
    all.area.merge(part->area);
    all.edge_lengths.merge(part->edge_lengths);
    if (!part->has_box) continue;
    add_point(all, part->low);
    add_point(all, part->high);
  }
  InfoReport report;
  report.faces = all.faces;
  report.bad_faces = all.bad;
  report.zero_area = all.zero_area;
  report.has_box = all.has_box;
  report.box_min = all.low;
  report.box_max = all.high;
  report.area = all.area.value();
  report.mean_edge = all.sides == 0 ? 0 : all.edge_lengths.value() / static_cast<double>(all.sides);
  report.edges = edges_.finish();
  return report;
}

}  // namespace winnow
