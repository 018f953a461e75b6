// Noise is bounded, centred, smooth and the same wherever a point stands in its batch.
#include "generate/noise.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

using Noise = void (*)(const PointBatch&, const NoiseOctave&, NoiseValues&);

// A line of points through space, `step` apart.
PointBatch line(int start, double step) {
  PointBatch points;
  points.count = batch_points;
  for (std::size_t k = 0; k < batch_points; ++k) {
    const double at = start * 0.37 + step * static_cast<double>(k);
    points.x[k] = at;
    points.y[k] = 0.71 * at + 0.3 * start;
    points.z[k] = 3 - 0.43 * at;
  }
  return points;
}

}  // namespace

TEST_CASE("noise is bounded, centred and smooth") {
  for (const Noise noise : {&space_noise, &plane_noise}) {
    const NoiseOctave octave{5, 123};
    double sum = 0;
    float most = 0;
    float steepest = 0;
    constexpr int lines = 2000;
    constexpr double step = 0.001;
    for (int start = 0; start < lines; ++start) {
      NoiseValues values;
      noise(line(start, step), octave, values);
      for (std::size_t k = 0; k < batch_points; ++k) {
        sum += static_cast<double>(values[k]);
        most = std::max(most, std::abs(values[k]));
        if (k > 0) steepest = std::max(steepest, std::abs(values[k] - values[k - 1]));
      }
    }
    CAPTURE(most, steepest, sum / (lines * batch_points));
    CHECK(std::abs(sum / (lines * batch_points)) < 0.02);
    CHECK(most > 0.4F);
    CHECK(most < 1);
    // The direction of the line is 1.3 long; slopes are below 2.7 a cell.
    CHECK(steepest < 2.7F * 5 * 1.3F * static_cast<float>(step));
  }
}

TEST_CASE("noise of a point does not depend on its neighbours") {
  for (const Noise noise : {&space_noise, &plane_noise}) {
    const NoiseOctave octave{17, 9};
    const PointBatch all = line(3, 0.01);
    NoiseValues values;
    noise(all, octave, values);
    for (std::size_t k = 0; k < batch_points; ++k) {
      PointBatch one;
      one.count = 1;
      one.x[0] = all.x[k];
      one.y[0] = all.y[k];
      one.z[0] = all.z[k];
      NoiseValues value;
      noise(one, octave, value);
      CHECK(value[0] == values[k]);
    }
  }
}

}  // namespace winnow
