#include "generate/relief.hpp"

#include "generate/seed_stream.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

Relief::Relief(std::uint32_t seed) {
  SeedStream random(std::uint64_t{seed} + (std::uint64_t{1} << 32));
  face_ = {
      {{0.47, 0.00, 0.50}, {0.30, 0.080, 0.19}, 0.070},    // bridge of the nose
      {{0.47, 0.00, 0.43}, {0.30, 0.110, 0.10}, 0.070},    // its tip
      {{0.42, 0.16, 0.58}, {0.25, 0.140, 0.09}, -0.050},   // eye sockets
      {{0.42, -0.16, 0.58}, {0.25, 0.140, 0.09}, -0.050},  //
      {{0.42, 0.15, 0.575}, {0.25, 0.090, 0.055}, 0.035},  // eyes
      {{0.42, -0.15, 0.575}, {0.25, 0.090, 0.055}, 0.035},
      {{0.42, 0.13, 0.68}, {0.25, 0.190, 0.055}, 0.030},  // brows
      {{0.42, -0.13, 0.68}, {0.25, 0.190, 0.055}, 0.030},
      {{0.42, 0.00, 0.315}, {0.25, 0.150, 0.075}, 0.035},   // lips
      {{0.42, 0.00, 0.315}, {0.25, 0.140, 0.018}, -0.022},  // mouth
      {{0.40, 0.00, 0.20}, {0.25, 0.140, 0.090}, 0.040},    // chin
      {{0.30, 0.22, 0.44}, {0.25, 0.140, 0.120}, 0.020},    // cheeks
      {{0.30, -0.22, 0.44}, {0.25, 0.140, 0.120}, 0.020},
      {{-0.02, 0.38, 0.53}, {0.09, 0.200, 0.140}, 0.060},  // ears
      {{-0.02, -0.38, 0.53}, {0.09, 0.200, 0.140}, 0.060},
      {{0.01, 0.42, 0.53}, {0.05, 0.200, 0.080}, -0.035},
      {{0.01, -0.42, 0.53}, {0.05, 0.200, 0.080}, -0.035},
      {{0.30, 0.20, -0.14}, {0.25, 0.240, 0.035}, 0.020},  // collar bones
      {{0.30, -0.20, -0.14}, {0.25, 0.240, 0.035}, 0.020},
      {{0.40, 0.20, -0.42}, {0.30, 0.220, 0.180}, 0.030},  // breast
      {{0.40, -0.20, -0.42}, {0.30, 0.220, 0.180}, 0.030},
  };
  for (Bump& bump : face_) {
    bump.height *= random.between(0.8, 1.2);
    bump.middle[2] += random.between(-0.01, 0.01);
    for (double& size : bump.size) size *= random.between(0.9, 1.1);
  }
  hair_ = {{-0.22, 0, 0.72}, {0.55, 0.60, 0.62}, 1.0};
  // Cells from a third of the whole down to a few edges of a mesh of 20 million faces; about three
  // to one, so that five octaves reach that far. Wear and grain each add slopes of some 5 degrees.
  swell_ = {NoiseOctave{2.9, random.bits()}, NoiseOctave{7.7, random.bits()}};
  strands_ = {19.0, random.bits()};
  wear_ = {61.0, random.bits()};
  grain_ = {243.0, random.bits()};
}

void Relief::add(const Bump& bump, const PointBatch& points, NoiseValues& sum) {
  const double sx = 1 / bump.size[0];
  const double sy = 1 / bump.size[1];
  const double sz = 1 / bump.size[2];
  const auto raise = static_cast<float>(bump.height);
  for (std::size_t k = 0; k < points.count; ++k) {
    const auto x = static_cast<float>((points.x[k] - bump.middle[0]) * sx);
    const auto y = static_cast<float>((points.y[k] - bump.middle[1]) * sy);
    const auto z = static_cast<float>((points.z[k] - bump.middle[2]) * sz);
    const float inside = std::max(0.0F, 1 - (x * x + y * y + z * z));
    sum[k] += raise * (inside * inside);
  }
}

void Relief::heights(const PointBatch& points, NoiseValues& height) const {
  const std::size_t count = points.count;
  std::fill_n(height.begin(), count, 0.0F);
  // Batches are mostly pieces of one ring, and most bumps are not on it. Leaving those out changes
  // no bit: beyond its ellipsoid a bump adds nothing but zero.
  const auto [lowest, highest] = std::minmax_element(points.z.begin(), points.z.begin() + count);
  for (const Bump& bump : face_) {
    if (*lowest <= bump.middle[2] + bump.size[2] && *highest >= bump.middle[2] - bump.size[2]) {
      add(bump, points, height);
    }
  }

  NoiseValues noise;
  space_noise(points, swell_[0], noise);
  for (std::size_t k = 0; k < count; ++k) height[k] += 0.030F * noise[k];
  space_noise(points, swell_[1], noise);
  for (std::size_t k = 0; k < count; ++k) height[k] += 0.014F * noise[k];

  // Sharp crests where the noise changes its sign: strands on the head, faint creases elsewhere.
  NoiseValues hair;
  std::fill_n(hair.begin(), count, 0.15F);
  add(hair_, points, hair);
  space_noise(points, strands_, noise);
  for (std::size_t k = 0; k < count; ++k) {
    const float crest = 1 - 2 * std::abs(noise[k]);
    height[k] += 0.022F * hair[k] * (crest * crest);
  }

  space_noise(points, wear_, noise);
  for (std::size_t k = 0; k < count; ++k) height[k] += 0.0016F * noise[k];
  space_noise(points, grain_, noise);
  for (std::size_t k = 0; k < count; ++k) height[k] += 0.00035F * noise[k];
}

}  // namespace winnow
