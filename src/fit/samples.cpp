#include "fit/samples.hpp"

#include "base/memory_shares.hpp"
#include "base/per_slot.hpp"
#include "measure/surface_sampler.hpp"
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

// The fraction of a point for a face with this number. Numbers that follow each other are mostly
// those of faces side by side, and steps by the golden ratio take the same part of any row of them:
// hashes would leave gaps.
double fraction_of(std::uint32_t number) {
  return static_cast<double>(number * 0x9e3779b9U) * 0x1p-32;
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
        // Alone it stands for all of its face.
        add(count == 1 ? middle_of(t) : SurfaceSampler::point(faces.number(i), k, t), own);
        if (own.size() >= 3 * gathered) hand_on(own);
      }
    }
  }

  void finish() {
    for (std::vector<Real>* own : slots_.all()) hand_on(*own);
  }

 private:
  static Point middle_of(const Triangle& t) { return 1.0 / 3 * (t[0] + t[1] + t[2]); }

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

}  // namespace

void Samples::read(std::uint64_t first, std::size_t count, std::vector<Point>& out) const {
  std::vector<std::byte> bytes(count * point_bytes());
  points->read(first * point_bytes(), bytes);
  out.resize(count);
  if (single) {
    take<float>(bytes, out);
  } else {
    take<double>(bytes, out);
  }
}

Samples sample_faces(Job& job, MeshReader& reader, std::uint64_t wanted_faces, double area) {
  Samples samples;
  if (!(area > 0)) return samples;
  const double usual = samples_a_face * static_cast<double>(wanted_faces);
  const double density = std::max(usual, std::min(2 * usual, few_samples)) / area;
  samples.points = std::make_unique<Spool>(job, share::left::samples(job.budget.left()));
  samples.single = !reader.facts().double_positions;
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

}  // namespace winnow
