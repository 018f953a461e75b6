// Smooth random functions of space: gradient noise, after Perlin, "Improving Noise" (SIGGRAPH
// 2002), with an integer hash in place of his permutation table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace winnow {

inline constexpr std::size_t batch_points =
    256;  // all arrays of a batch together stay in the first cache

// Points side by side, an array an axis, so that loops over them vectorise.
struct PointBatch {
  alignas(64) std::array<double, batch_points> x, y, z;
  std::size_t count = 0;
};

using NoiseValues = std::array<float, batch_points>;

// `frequency` is the number of noise cells a unit. Measured: values within -0.9 and 0.9, mean 0,
// slopes 0.8 times the frequency in the mean square and 2.7 times at most. The points must lie
// within 32,000 cells of the origin.
struct NoiseOctave {
  double frequency;
  std::uint32_t seed;
};

void space_noise(const PointBatch& points, const NoiseOctave& octave, NoiseValues& values);
void plane_noise(const PointBatch& points, const NoiseOctave& octave,
                 NoiseValues& values);  // of x and y

}  // namespace winnow
