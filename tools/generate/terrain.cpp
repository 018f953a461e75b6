// A height field over a rectangle, with a rim: hills, ridges and flat lakes.
#include "generate/noise.hpp"
#include "generate/row_grid.hpp"
#include "generate/seed_stream.hpp"
#include "generate/surface.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

constexpr double half_width = 1.0;
constexpr double half_depth = 0.75;
constexpr std::size_t octaves = 9;

class Terrain final : public GeneratedSurface {
 public:
  explicit Terrain(const GenerateOptions& options)
      : grid_(nearest_grid(options.faces / 2, half_width / half_depth, {1, 1})) {
    SeedStream random(std::uint64_t{options.seed} + (std::uint64_t{2} << 32));
    // The finest cells are some four edges wide in a mesh of 20 million faces. Not quite two to
    // one: the zeros of gradient noise would come to lie on each other.
    double frequency = 1.7;
    for (NoiseOctave& octave : noise_) {
      octave = {frequency, random.bits()};
      frequency *= 1.93;
    }
  }

  [[nodiscard]] std::uint64_t vertices() const override {
    return (grid_.columns + 1) * (grid_.rows + 1);
  }
  [[nodiscard]] std::uint64_t faces() const override { return 2 * grid_.columns * grid_.rows; }

  void positions(std::span<const std::uint64_t> ids, std::span<Point> points) const override {
    for (std::size_t at = 0; at < ids.size(); at += batch_points) {
      const std::size_t count = std::min(batch_points, ids.size() - at);
      evaluate(ids.subspan(at, count), points.subspan(at, count));
    }
  }

  void corners(std::span<const std::uint64_t> ids, std::span<MeshFace> corners) const override;

 private:
  void evaluate(std::span<const std::uint64_t> ids, std::span<Point> points) const;

  RowGrid grid_;  // of squares
  std::array<NoiseOctave, octaves> noise_{};
};

void Terrain::evaluate(std::span<const std::uint64_t> ids, std::span<Point> points) const {
  const std::size_t count = ids.size();
  PointBatch batch;
  batch.count = count;
  RowFinder finder(grid_.columns + 1);
  for (std::size_t k = 0; k < count; ++k) {
    finder.find(ids[k]);
    const std::uint64_t column = ids[k] - finder.begin();
    batch.x[k] =
        half_width * (2 * static_cast<double>(column) / static_cast<double>(grid_.columns) - 1);
    batch.y[k] =
        half_depth * (2 * static_cast<double>(finder.row()) / static_cast<double>(grid_.rows) - 1);
  }

  NoiseValues land;
  NoiseValues rough;  // plains are smooth, mountains are not: fine octaves follow the coarse ones
  NoiseValues noise;
  plane_noise(batch, noise_[0], noise);
  for (std::size_t k = 0; k < count; ++k) {
    land[k] = 0.24F * noise[k];
    rough[k] = std::max(0.06F, 0.40F + 0.90F * noise[k]);
  }
  plane_noise(batch, noise_[1], noise);
  for (std::size_t k = 0; k < count; ++k) {
    const float crest = 1 - std::abs(noise[k]) * 1.6F;
    land[k] += 0.15F * rough[k] * (crest * crest - 0.5F);
  }
  float height = 0.08F;
  for (std::size_t octave = 2; octave < octaves; ++octave) {
    plane_noise(batch, noise_[octave], noise);
    if (octave < 5) {
      for (std::size_t k = 0; k < count; ++k) {
        const float crest = 1 - std::abs(noise[k]) * 1.6F;
        land[k] += height * rough[k] * (crest * crest - 0.5F);
      }
    } else {
      for (std::size_t k = 0; k < count; ++k) land[k] += height * rough[k] * noise[k];
    }
    height *= 0.46F;
  }
  constexpr float lake = -0.05F;
  for (std::size_t k = 0; k < count; ++k) {
    points[k] = {batch.x[k], batch.y[k], static_cast<double>(std::max(land[k], lake))};
  }
}

void Terrain::corners(std::span<const std::uint64_t> ids, std::span<MeshFace> corners) const {
  RowFinder finder(2 * grid_.columns);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    finder.find(ids[k]);
    const std::uint64_t within = ids[k] - finder.begin();
    const std::uint64_t here = finder.row() * (grid_.columns + 1) + within / 2;
    const std::uint64_t above = here + grid_.columns + 1;
    if (within % 2 == 0) {
      corners[k].vertex = {here, here + 1, above + 1};
    } else {
      corners[k].vertex = {here, above + 1, above};
    }
  }
}

}  // namespace

std::unique_ptr<GeneratedSurface> make_terrain(const GenerateOptions& options) {
  return std::make_unique<Terrain>(options);
}

}  // namespace winnow
