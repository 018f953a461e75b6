#include "fit/vertex_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace winnow {

namespace {

// How far off a sample may be that lies on a face, in sample_roundings of coordinates.
constexpr double sample_roundings = 2;
// Along a face distances count by this part: where a sample is nearest to moves with the surface,
// so samples hardly keep a vertex from sliding along it.
constexpr double along_face = 0.003;
// A pull to the old place, as a part of what the samples of a vertex weigh, in the mean.
constexpr double pull_back = 0.02;
// More steps change nothing to speak of.
constexpr int steps = 8;
// A face may be so many times as far off as its farthest sample; and where it moves a pointed
// vertex, which samples are hardly ever nearest to.
constexpr double beyond_samples = 1.5;
constexpr double beyond_samples_at_tips = 3;
// At a pointed vertex the mean of the faces' unit normals is shorter than this.
constexpr double shortest_mean_normal = 0.8;
// What moves by less than this part of the limit makes the largest distance hardly larger.
constexpr double small_move = 0.045;

Point point_of(const std::array<float, 3>& p) {
  return {double{p[0]}, double{p[1]}, double{p[2]}};
}

// The corners of each vertex: 3 * face + place.
class CornersOfVertices {
 public:
  CornersOfVertices(std::size_t vertices, std::span<const FaceVertices> faces)
      : first_(vertices + 1, 0), corner_(3 * faces.size()) {
    for (const FaceVertices& face : faces) {
      for (const std::uint32_t v : face) ++first_[v + 1];
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      for (std::uint32_t i = 0; i < 3; ++i) corner_[first_[faces[f][i]]++] = 3 * f + i;
    }
    // Each begin has come to where the next one was.
    for (std::size_t v = first_.size() - 1; v > 0; --v) first_[v] = first_[v - 1];
    first_[0] = 0;
  }

  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t v) const {
    return std::span(corner_).subspan(first_[v], first_[v + 1] - first_[v]);
  }

 private:
  std::vector<std::uint32_t> first_, corner_;
};

using Corners = std::array<bool, 3>;

class Fitter {
 public:
  Fitter(std::vector<Point>& positions, std::span<const FaceVertices> faces,
         std::span<const FaceSums> sums, std::span<const std::uint8_t> locked,
         const VertexFitSettings& settings, const FartherCorners& farther,
         const std::function<void()>& turn)
      : position_(positions),
        face_(faces),
        sums_(sums),
        settings_(settings),
        farther_(farther),
        turn_(turn),
        corners_(positions.size(), faces),
        free_(positions.size(), 0) {
    std::vector<std::uint32_t> met;
    for (std::uint32_t v = 0; v < free_.size(); ++v)
      free_[v] = locked[v] == 0 && (settings_.boundaries || is_inside(v, met)) ? 1 : 0;
    for (std::size_t f = 0; f < face_.size(); ++f) {
      if (!is_met(f)) continue;
      for (const std::uint32_t v : face_[f]) free_[v] = 0;
    }
    turn_();
  }

  FittedVertices run() {
    FittedVertices done;
    if (!solve()) return done;
    const std::vector<Point> before = position_;
    for (std::uint32_t v = 0; v < free_.size(); ++v) {
      if (free_[v] == 0) continue;
      Point to = position_[v] + move_[v];
      if (settings_.single) {
        for (double& x : to) x = nearest_float(x);
      }
      if (finite(to)) position_[v] = to;
    }
    // Whether faces are near the original takes longer to tell.
    find_pointed();
    take_back(before, [&](std::size_t f) { return turned_corners(before, f); });
    take_back(before, [&](std::size_t f) {
      const Corners turned = turned_corners(before, f);
      return turned[0] ? turned : farther_corners(before, f);
    });
    for (std::uint32_t v = 0; v < free_.size(); ++v) {
      if (position_[v] != before[v]) done.moved.push_back(v);
    }
    done.gain = gain(before);
    return done;
  }

 private:
  [[nodiscard]] Triangle triangle(const std::vector<Point>& positions, std::size_t f) const {
    return {positions[face_[f][0]], positions[face_[f][1]], positions[face_[f][2]]};
  }

  // Whether every edge of the vertex has two faces. `met` is used.
  [[nodiscard]] bool is_inside(std::uint32_t v, std::vector<std::uint32_t>& met) const {
    met.clear();
    for (const std::uint32_t corner : corners_.of(v)) {
      const FaceVertices& face = face_[corner / 3];
      for (std::uint32_t i = 1; i < 3; ++i) met.push_back(face[(corner + i) % 3]);
    }
    std::sort(met.begin(), met.end());
    for (std::size_t i = 0; i < met.size(); i += 2) {
      if (met[i] != met[i + 1] || (i > 0 && met[i] == met[i - 1])) return false;
    }
    return true;
  }

  // Whether all samples of the face lie on it but for rounding.
  [[nodiscard]] bool is_met(std::size_t f) const {
    if (!(sums_[f].count() > 0.5)) return false;
    Point off{};
    for (const std::uint32_t v : face_[f]) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        off[axis] = std::max(off[axis], std::abs(position_[v][axis]));
    }
    for (double& x : off)
      x = sample_roundings * (settings_.rounding.relative * x + settings_.rounding.absolute);
    return double{sums_[f].farthest} <= dot(off, off);
  }

  // How a distance counts at a face.
  [[nodiscard]] Point weighted(std::size_t f, const Point& p) const {
    const Point normal = point_of(normal_[f]);
    return along_face * p + (1 - along_face) * dot(normal, p) * normal;
  }

  // The normal equations times `x`; 0 for vertices that stay.
  void multiply(const std::vector<Point>& x, std::vector<Point>& out) const {
    for (std::size_t v = 0; v < x.size(); ++v) out[v] = hold_ * x[v];
    for (std::size_t f = 0; f < face_.size(); ++f) {
      const FaceVertices& face = face_[f];
      if ((free_[face[0]] | free_[face[1]] | free_[face[2]]) == 0) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        Point sum{};
        for (std::size_t k = 0; k < 3; ++k) sum = sum + sums_[f].product(i, k) * x[face[k]];
        out[face[i]] = out[face[i]] + weighted(f, sum);
      }
    }
    for (std::size_t v = 0; v < x.size(); ++v) {
      if (free_[v] == 0) out[v] = Point{};
    }
  }

  static double product(const std::vector<Point>& a, const std::vector<Point>& b) {
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v) sum += dot(a[v], b[v]);
    return sum;
  }

  // Conjugate gradients, with the diagonal as preconditioner. False where nothing moves.
  bool solve() {
    const std::size_t vertices = position_.size();
    normal_.resize(face_.size());
    for (std::size_t f = 0; f < face_.size(); ++f) {
      const Point normal = unit(doubled_area(triangle(position_, f)));
      for (std::size_t axis = 0; axis < 3; ++axis)
        normal_[f][axis] = static_cast<float>(normal[axis]);
    }
    std::vector<Point> rest(vertices, Point{});
    std::vector<Point> diagonal(vertices, Point{});
    double weight = 0;
    for (std::size_t f = 0; f < face_.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = face_[f][i];
        if (free_[v] == 0) continue;
        const double own = sums_[f].product(i, i);
        rest[v] = rest[v] + weighted(f, point_of(sums_[f].pull[i]));
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double n = double{normal_[f][axis]};
          diagonal[v][axis] += own * (along_face + (1 - along_face) * n * n);
        }
        weight += own;
      }
    }
    if (!(weight > 0)) return false;
    hold_ = pull_back * weight / static_cast<double>(std::count(free_.begin(), free_.end(), 1));
    const auto divided = [&](std::size_t v) {
      Point out;
      for (std::size_t axis = 0; axis < 3; ++axis)
        out[axis] = rest[v][axis] / (diagonal[v][axis] + hold_);
      return out;
    };
    move_.assign(vertices, Point{});
    std::vector<Point> way(vertices);
    std::vector<Point> forward(vertices);
    double slope = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
      way[v] = divided(v);
      slope += dot(rest[v], way[v]);
    }
    for (int step = 0; step < steps && slope > 0; ++step) {
      turn_();
      multiply(way, forward);
      const double along = product(way, forward);
      if (!(along > 0)) break;
      const double far = slope / along;
      double next = 0;
      for (std::size_t v = 0; v < vertices; ++v) {
        move_[v] = move_[v] + far * way[v];
        rest[v] = rest[v] - far * forward[v];
        next += dot(rest[v], divided(v));
      }
      for (std::size_t v = 0; v < vertices; ++v) way[v] = divided(v) + (next / slope) * way[v];
      slope = next;
    }
    return true;
  }

  // All corners of a face that turns too far or becomes a line.
  [[nodiscard]] Corners turned_corners(const std::vector<Point>& before, std::size_t f) const {
    const Triangle to = triangle(position_, f);
    const Point from_normal = doubled_area(triangle(before, f));
    const Point normal = doubled_area(to);
    const double size = length(from_normal) * length(normal);
    const bool allowed = size > 0 && dot(from_normal, normal) >= settings_.least_cosine * size &&
                         !thinner_than_rounding(to, normal, coordinate_rounding(settings_.single));
    return {!allowed, !allowed, !allowed};
  }

  void find_pointed() {
    std::vector<Point> sum(position_.size(), Point{});
    for (std::size_t f = 0; f < face_.size(); ++f) {
      for (const std::uint32_t v : face_[f]) sum[v] = sum[v] + point_of(normal_[f]);
    }
    pointed_.resize(position_.size());
    for (std::uint32_t v = 0; v < pointed_.size(); ++v) {
      const auto faces = static_cast<double>(corners_.of(v).size());
      pointed_[v] = length(sum[v]) < shortest_mean_normal * faces ? 1 : 0;
    }
  }

  // How far off the face may be, as far as its samples tell, if it is farther than before.
  [[nodiscard]] double farthest_now(const std::vector<Point>& before, std::size_t f) const {
    const Point normal = point_of(normal_[f]);
    double moved = 0;
    double beyond = beyond_samples;
    for (const std::uint32_t v : face_[f]) {
      const Point by = position_[v] - before[v];
      const bool tip = pointed_[v] != 0 && by != Point{};
      if (tip) beyond = beyond_samples_at_tips;
      moved = std::max(moved, tip ? length(by) : std::abs(dot(normal, by)));
    }
    if (moved < small_move * settings_.far) return 0;
    return beyond * std::sqrt(double{sums_[f].farthest}) + moved;
  }

  // Samples say little of what sticks out: they have no nearest place at the tip of a spike of the
  // result, and the tips of the original are few. So faces that may be far off are looked at.
  [[nodiscard]] Corners farther_corners(const std::vector<Point>& before, std::size_t f) const {
    if (farthest_now(before, f) < settings_.far) return {};
    std::vector<Triangle> from{triangle(before, f)};
    std::vector<Triangle> to{triangle(position_, f)};
    for (const std::uint32_t v : face_[f]) {
      for (const std::uint32_t corner : corners_.of(v)) {
        if (corner / 3 == f) continue;
        from.push_back(triangle(before, corner / 3));
        to.push_back(triangle(position_, corner / 3));
      }
    }
    return farther_(from, to);
  }

  // corners(f): those of a face that may not be where they are. They go back, and then the faces
  // around them are looked at.
  template <typename CornersOf>
  void take_back(const std::vector<Point>& before, const CornersOf& corners) {
    std::vector<std::uint32_t> suspects;
    const auto look_at = [&](std::uint32_t f) {
      const auto moved = [&](std::uint32_t v) { return position_[v] != before[v]; };
      if (std::none_of(face_[f].begin(), face_[f].end(), moved)) return;
      const Corners back = corners(f);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = face_[f][i];
        if (!back[i] || !moved(v)) continue;
        position_[v] = before[v];
        for (const std::uint32_t corner : corners_.of(v)) suspects.push_back(corner / 3);
      }
    };
    for (std::uint32_t f = 0; f < face_.size(); ++f) {
      if (f % 1024 == 0) turn_();
      look_at(f);
      while (!suspects.empty()) {
        const std::uint32_t beside = suspects.back();
        suspects.pop_back();
        look_at(beside);
      }
    }
  }

  [[nodiscard]] double gain(const std::vector<Point>& before) const {
    double all = 0;
    for (std::size_t f = 0; f < face_.size(); ++f) {
      const Point normal = point_of(normal_[f]);
      std::array<double, 3> move{};
      for (std::size_t i = 0; i < 3; ++i)
        move[i] = dot(normal, position_[face_[f][i]] - before[face_[f][i]]);
      double squares = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        squares -= 2 * move[i] * dot(normal, point_of(sums_[f].pull[i]));
        for (std::size_t k = 0; k < 3; ++k) squares += move[i] * move[k] * sums_[f].product(i, k);
      }
      all -= squares;
    }
    return all;
  }

  std::vector<Point>& position_;
  std::span<const FaceVertices> face_;
  std::span<const FaceSums> sums_;
  const VertexFitSettings& settings_;
  const FartherCorners& farther_;
  const std::function<void()>& turn_;
  CornersOfVertices corners_;
  std::vector<std::uint8_t> free_, pointed_;
  std::vector<std::array<float, 3>> normal_;
  std::vector<Point> move_;
  double hold_ = 0;
};

}  // namespace

FittedVertices fit_vertices(std::vector<Point>& positions, std::span<const FaceVertices> faces,
                            std::span<const FaceSums> sums, std::span<const std::uint8_t> locked,
                            const VertexFitSettings& settings, const FartherCorners& farther,
                            const std::function<void()>& turn) {
  return Fitter(positions, faces, sums, locked, settings, farther, turn).run();
}

std::uint64_t vertex_fit_memory(std::uint64_t vertices, std::uint64_t faces) {
  // The equations take five points a vertex. What comes when they are solved takes less: positions
  // as they were, moves, and at most all corners as suspects.
  return vertices * (5 * sizeof(Point) + sizeof(std::uint32_t) + 2) +
         faces * (3 * sizeof(std::uint32_t) + sizeof(std::array<float, 3>));
}

}  // namespace winnow
