// A comparison is what looking at every face for every point gives.
#include <winnow/compare.hpp>

#include "base/closest_point.hpp"
#include "measure/surface_sampler.hpp"
#include "support/files.hpp"
#include "support/random.hpp"
#include "support/stl_file.hpp"
#include "support/surfaces.hpp"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

using Faces = std::vector<Triangle>;

// As the file holds them.
Faces in_floats(Faces faces) {
  for (Triangle& face : faces) {
    for (Point& p : face) {
      for (double& x : p) x = static_cast<double>(static_cast<float>(x));
    }
  }
  return faces;
}

double area(const Faces& faces) {
  double sum = 0;
  for (const Triangle& face : faces) sum += length(area_vector(face));
  return sum;
}

double distance_to_all(const Point& p, const Faces& faces) {
  double best = INFINITY;
  for (const Triangle& face : faces) best = std::min(best, length(p - closest_point(p, face)));
  return best;
}

Distances by_looking_at_all(const Faces& from, const Faces& to, double samples) {
  const SurfaceSampler sampler(samples / area(from));
  Distances result;
  double sum = 0;
  double squares = 0;
  double count = 0;
  for (std::size_t f = 0; f < from.size(); ++f) {
    for (std::uint64_t k = 0; k < sampler.count(f, length(area_vector(from[f]))); ++k) {
      const double d = distance_to_all(SurfaceSampler::point(f, k, from[f]), to);
      sum += d;
      squares += d * d;
      result.max = std::max(result.max, d);
      ++count;
    }
    for (const Point& corner : from[f])
      result.max = std::max(result.max, distance_to_all(corner, to));
  }
  result.mean = sum / count;
  result.rms = std::sqrt(squares / count);
  return result;
}

void check_equal(const Distances& found, const Distances& right) {
  CHECK(found.mean == Approx(right.mean).epsilon(1e-12));
  CHECK(found.rms == Approx(right.rms).epsilon(1e-12));
  CHECK(found.max == Approx(right.max).epsilon(1e-12));
}

}  // namespace

TEST_CASE("a comparison is what looking at every face gives") {
  Random random(720);
  const Directory directory;
  const Faces bumpy = in_floats(ball(14, 0.2));
  const Faces smooth = in_floats(ball(9, 0.1));
  Faces soup = in_floats(random_triangles(random, 200, 1));
  for (const auto& [original, simplified] : {std::pair(bumpy, smooth), std::pair(smooth, bumpy),
                                             std::pair(soup, smooth), std::pair(bumpy, soup)}) {
    write_file(directory.file("original.stl"), binary_stl(original));
    write_file(directory.file("simplified.stl"), binary_stl(simplified));
    Context context;
    context.scratch = directory.path();
    CompareOptions options;
    options.samples = 3000;
    const CompareReport report =
        compare(context, directory.file("original.stl"), directory.file("simplified.stl"), options);
    check_equal(report.forward, by_looking_at_all(original, simplified, 3000));
    check_equal(report.backward, by_looking_at_all(simplified, original, 3000));
    // The worst point is that far away indeed.
    const double there = std::max(distance_to_all(report.worst, original),
                                  distance_to_all(report.worst, simplified));
    CHECK(there == Approx(report.symmetric.max).epsilon(1e-12));
  }
}

TEST_CASE("samples are spread evenly by area") {
  // A tall face and a hundred slivers of the same area in all.
  Faces faces{{Point{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  for (int i = 0; i < 100; ++i)
    faces.push_back({Point{2, 0.01 * i, 0}, {3, 0.01 * i, 0}, {2, 0.01 * (i + 1), 0}});
  const SurfaceSampler sampler(100'000 / area(faces));
  std::vector<double> counts;
  Point middle{};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::uint64_t count = sampler.count(f, length(area_vector(faces[f])));
    counts.push_back(static_cast<double>(count));
    for (std::uint64_t k = 0; k < count && f == 0; ++k)
      middle = middle + 1.0 / static_cast<double>(count) * SurfaceSampler::point(f, k, faces[f]);
  }
  CHECK(counts[0] == Approx(50'000).margin(1));
  for (std::size_t f = 1; f < counts.size(); ++f) CHECK(counts[f] == Approx(500).margin(1));
  CHECK(middle[0] == Approx(1.0 / 3).margin(0.005));
  CHECK(middle[1] == Approx(1.0 / 3).margin(0.005));
}

}  // namespace winnow::test
