// The cell size that gives a wanted number of faces, found from a sample.
#pragma once

#include "cluster/grid.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace winnow {

// A few positions of the input that predict how many cells a cell size occupies. A function of the
// positions alone, in whatever order and by whatever thread they come.
class CellSample {
 public:
  // Two passes over the positions: the box and a crude idea of the cell size, then the sample for it.
  CellSample(Job& job, MeshReader& reader, std::uint64_t wanted_faces);

  [[nodiscard]] const Box& box() const { return box_; }

  // Faces that clustering with this cell edge is expected to give.
  [[nodiscard]] double expected_faces(double cell) const;

  // The cell edge for which expected_faces() is `faces`, within the limits of the lattice.
  [[nodiscard]] double cell_for(double faces) const;

  // Memory used while sampling, and kept.
  static constexpr std::uint64_t memory(unsigned threads) { return (std::uint64_t{10} << 20) + threads * (std::uint64_t{3} << 20); }

 private:
  using Point = std::array<double, 3>;

  [[nodiscard]] double crude_cell(const std::vector<Point>& points, double cells) const;
  void sample_blocks(Job& job, MeshReader& reader);

  Box box_;
  std::uint64_t positions_ = 0;  // finite ones
  double block_ = 0;             // edge of a block, in model units
  std::uint64_t block_bound_ = 0;  // blocks whose hash is below are in the sample
  std::uint64_t point_bound_ = 0;  // of these, points whose hash is below
  std::vector<Point> points_;
  double scale_ = 1;  // all positions, per position in the sampled blocks
};

// The box of all finite positions, in one pass.
Box measure_box(Job& job, MeshReader& reader);

}  // namespace winnow
