// What a sculptor and the years put on the rough shape: a face, hair, folds, wear and grain.
#pragma once

#include "generate/noise.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace winnow {

class Relief {
 public:
  explicit Relief(std::uint32_t seed);

  // height[k]: by how much the surface is raised at a point of the rough shape.
  void heights(const PointBatch& points, NoiseValues& height) const;

 private:
  // A rounded bump (a hollow where the height is negative) inside an ellipsoid.
  struct Bump {
    std::array<double, 3> middle;
    std::array<double, 3> size;
    double height;
  };
  static void add(const Bump& bump, const PointBatch& points, NoiseValues& sum);

  std::vector<Bump> face_;
  Bump hair_{};
  std::array<NoiseOctave, 2> swell_{};
  NoiseOctave strands_{}, wear_{}, grain_{};
};

}  // namespace winnow
