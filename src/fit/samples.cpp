#include "fit/samples.hpp"

#include "base/box.hpp"
#include "base/hash.hpp"
#include "base/memory_shares.hpp"
#include "base/morton.hpp"
#include "base/per_slot.hpp"
#include "base/rank_order.hpp"
#include "read/for_each_batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <mutex>

namespace winnow {

namespace {

// Samples for each face that is wanted (bench/RESULTS.md). Few faces get twice as many, up to so
// many in all.
constexpr double samples_a_face = 12;
constexpr double few_samples = 1 << 18;
// Points that a thread gathers before it hands them on.
constexpr std::size_t gathered = 1024;
// Points that are handed on at once, or faces that they are taken from.
constexpr std::uint64_t part = 2048;
// Points that were kept are read so many at a time, and brought into an order of places.
constexpr std::uint64_t bytes_a_point = 2 * sizeof(Point) + RankOrder::bytes_a_place;

// The fraction of a point for a face with this number. Numbers that follow each other are mostly
// those of faces side by side, and steps by the golden ratio take the same part of any row of them:
// hashes would leave gaps.
double fraction_of(std::uint32_t number) {
  return static_cast<double>(number * 0x9e3779b9U) * 0x1p-32;
}

double density_for(std::uint64_t faces, double area) {
  const double usual = samples_a_face * static_cast<double>(faces);
  return std::max(usual, std::min(2 * usual, few_samples)) / area;
}

// The point with number `k` of `count` on a face: alone it stands for all of the face; several lie
// evenly, on a lattice of irrational steps that is folded at the middle of a side.
Point point_on(const Triangle& t, std::uint64_t number, std::uint64_t k, std::uint64_t count) {
  if (count == 1) return 1.0 / 3 * (t[0] + t[1] + t[2]);
  const std::uint64_t begin = mixed_hash(number);
  const auto fraction = [](std::uint64_t whole) {
    return static_cast<double>(whole >> 11) * 0x1p-53;
  };
  double second = fraction(begin + k * 0xc13fa9a902a6328fU);
  double third = fraction(mixed_hash(begin) + k * 0x91e10da5c79e7b1dU);
  if (second + third > 1) {
    second = 1 - second;
    third = 1 - third;
  }
  return t[0] + (second * (t[1] - t[0]) + third * (t[2] - t[0]));
}

// How many points each face gets; what is behind the point says nothing.
template <typename Stored>
void count_points(const FaceBatch& faces, const FaceBatch::Positions<Stored>& position,
                  double density, std::array<double, FaceBatch::capacity>& wanted) {
  for (std::size_t i = 0; i < faces.count; ++i) {
    std::array<double, 3> b, c;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double a = static_cast<double>(position[0][axis][i]);
      b[axis] = static_cast<double>(position[1][axis][i]) - a;
      c[axis] = static_cast<double>(position[2][axis][i]) - a;
    }
    const double x = b[1] * c[2] - b[2] * c[1];
    const double y = b[2] * c[0] - b[0] * c[2];
    const double z = b[0] * c[1] - b[1] * c[0];
    wanted[i] = density / 2 * std::sqrt(x * x + y * y + z * z);
  }
  for (std::size_t i = 0; i < faces.count; ++i) wanted[i] += fraction_of(faces.number(i));
}

template <typename Real>
class Gatherer {
 public:
  Gatherer(Job& job, Spool& points)
      : job_(job),
        points_(points),
        slots_(job.threads, [] { return std::make_unique<std::vector<Real>>(); }) {}

  void add(const FaceBatch& faces, double density) {
    std::vector<Real>& own = slots_.local();
    std::array<double, FaceBatch::capacity> wanted;
    if (faces.single) {
      count_points(faces, faces.single_position, density, wanted);
    } else {
      count_points(faces, faces.position, density, wanted);
    }
    for (std::size_t i = 0; i < faces.count; ++i) {
      // Not where a corner is no number.
      if (!(wanted[i] >= 1 && wanted[i] < 1e15) || faces.status[i] != FaceStatus::good) continue;
      const Triangle t{faces.corner(0, i), faces.corner(1, i), faces.corner(2, i)};
      const auto count = static_cast<std::uint64_t>(wanted[i]);
      for (std::uint64_t k = 0; k < count; ++k) {
        add(point_on(t, faces.number(i), k, count), own);
        if (own.size() >= 3 * gathered) hand_on(own);
      }
    }
  }

  void finish() {
    for (std::vector<Real>* own : slots_.all()) hand_on(*own);
  }

 private:
  static void add(const Point& point, std::vector<Real>& own) {
    for (const double x : point) own.push_back(static_cast<Real>(x));
  }

  void hand_on(std::vector<Real>& own) {
    job_.progress.check_cancelled();
    const std::scoped_lock lock(mutex_);
    points_.append(std::as_bytes(std::span(own)));
    own.clear();
  }

  Job& job_;
  Spool& points_;
  std::mutex mutex_;
  PerSlot<std::vector<Real>> slots_;
};

template <typename Real>
void sample(Job& job, MeshReader& reader, double density, Spool& points) {
  Gatherer<Real> gatherer(job, points);
  reader.begin_faces();
  for_each_face_batch(job, reader, [&](const FaceBatch& faces) { gatherer.add(faces, density); },
                      {});
  gatherer.finish();
}

template <typename Real>
void take(std::span<const std::byte> bytes, std::vector<Point>& out) {
  for (Point& point : out) {
    std::array<Real, 3> xyz;
    std::memcpy(xyz.data(), bytes.data(), sizeof xyz);
    bytes = bytes.subspan(sizeof xyz);
    point = {double{xyz[0]}, double{xyz[1]}, double{xyz[2]}};
  }
}

std::vector<Point> points_of(const Samples& samples, std::uint64_t first, std::uint64_t count) {
  std::vector<std::byte> bytes(count * samples.point_bytes());
  samples.points->read(first * samples.point_bytes(), bytes);
  std::vector<Point> out(count);
  if (samples.single) {
    take<float>(bytes, out);
  } else {
    take<double>(bytes, out);
  }
  return out;
}

// By Morton numbers in their box.
std::vector<Point> by_places(const std::vector<Point>& points) {
  Box box;
  for (const Point& point : points) box.add(point);
  constexpr double cells = 1 << 11;
  const double scale = box.longest_side() > 0 ? (cells - 1) / box.longest_side() : 0;
  RankOrder order;
  std::vector<Point> out;
  out.reserve(points.size());
  const auto cell = [&](const Point& point, std::size_t axis) {
    return static_cast<std::uint32_t>(std::min(cells - 1, scale * (point[axis] - box.low[axis])));
  };
  for (const RankOrder::Place& place : order.sort(
           points.size(),
           [&](std::uint32_t i) {
             return morton_key(cell(points[i], 0), cell(points[i], 1), cell(points[i], 2));
           },
           [](std::uint32_t, std::uint32_t) { return false; }))
    out.push_back(points[place.number]);
  return out;
}

}  // namespace

Samples sample_faces(Job& job, MeshReader& reader, std::uint64_t wanted_faces, double area) {
  Samples samples;
  samples.area = area;
  samples.single = !reader.facts().double_positions;
  if (!(area > 0)) return samples;
  const double density = density_for(wanted_faces, area);
  samples.points = std::make_unique<Spool>(job, share::left::samples(job.budget.left()));
  job.progress.begin("sample", reader.facts().faces.value_or(0), "faces");
  if (samples.single) {
    sample<float>(job, reader, density, *samples.points);
  } else {
    sample<double>(job, reader, density, *samples.points);
  }
  samples.points->finish();
  reader.release_memory();
  return samples;
}

SampledSurface::SampledSurface(const Samples& samples, const StoredMesh& original,
                               std::uint64_t wanted_faces)
    : samples_(samples),
      original_(original),
      density_(density_for(wanted_faces, samples.area)),
      block_(part) {}

void SampledSurface::use(std::uint64_t memory) {
  if (samples_.points != nullptr)
    block_ = std::clamp(memory, least_memory, most_memory) / bytes_a_point;
}

std::uint64_t SampledSurface::expected() const {
  if (samples_.points != nullptr) return samples_.points->size() / samples_.point_bytes();
  return static_cast<std::uint64_t>(density_ * samples_.area);
}

std::uint64_t SampledSurface::most() const {
  return expected() + (samples_.points != nullptr ? 0 : original_.face_count);
}

std::uint64_t SampledSurface::blocks() const {
  const std::uint64_t all = samples_.points != nullptr ? expected() : original_.face_count;
  return (all + block_ - 1) / block_;
}

void SampledSurface::for_each_part(std::uint64_t number, const Each& each) const {
  const std::uint64_t first = number * block_;
  if (samples_.points != nullptr) {
    const std::vector<Point> points =
        by_places(points_of(samples_, first, std::min(block_, expected() - first)));
    for (std::span<const Point> rest(points); !rest.empty();) {
      const std::size_t now = std::min<std::size_t>(rest.size(), part);
      each(rest.first(now));
      rest = rest.subspan(now);
    }
    return;
  }
  VertexIndex::Reader vertices(*original_.vertices);
  const std::vector<FaceVertices> faces =
      original_.read_faces(first, std::min(block_, original_.face_count - first));
  std::vector<Point> points;
  // Some faces at a time: what they want takes no branches, and who gets a point is hard to
  // foresee.
  std::array<Triangle, 64> corners;
  std::array<double, 64> wanted;
  for (std::size_t begin = 0; begin < faces.size(); begin += corners.size()) {
    const std::size_t now = std::min(corners.size(), faces.size() - begin);
    for (std::size_t i = 0; i < now; ++i) {
      const auto& [a, b, c] = faces[begin + i];
      corners[i] = {vertices.position(a), vertices.position(b), vertices.position(c)};
      wanted[i] = density_ / 2 * length(doubled_area(corners[i])) +
                  fraction_of(static_cast<std::uint32_t>(first + begin + i));
    }
    for (std::size_t i = 0; i < now; ++i) {
      const auto count = static_cast<std::uint64_t>(wanted[i] < 1e15 ? wanted[i] : 0);
      for (std::uint64_t k = 0; k < count; ++k) {
        points.push_back(point_on(corners[i], first + begin + i, k, count));
        if (points.size() < part) continue;
        each(points);
        points.clear();
      }
    }
  }
  each(points);
}

}  // namespace winnow
