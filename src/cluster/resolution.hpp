// The cell size that gives a wanted number of faces, found before the first face is clustered.
#pragma once

#include "cluster/grid.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace winnow {

// How many cells the positions of an input occupy at cell sizes around the wanted one. A function
// of the positions and their order in the file, whatever thread sees them when.
class CellCounts {
 public:
  // Two passes over the positions: the box, as measure_surface() finds it, and a crude guess from a
  // few of them; then all of them are counted into cells of three sizes around the guess.
  // `positions`: how many there are (corners, without vertices).
  CellCounts(Job& job, MeshReader& reader, std::uint64_t positions, std::uint64_t wanted_faces);

  [[nodiscard]] const Box& box() const { return box_; }

  // The cell edge for which the number of faces is expected to be `faces`, within the limits of the
  // lattice.
  [[nodiscard]] double cell_for(double faces) const;

  [[nodiscard]] double smallest_cell() const;  // so that the lattice has room for a shifted copy

  // Faces that clustering with this cell edge is expected to give.
  [[nodiscard]] double expected_faces(double cell) const;

  static std::uint64_t memory(unsigned threads);  // the most it uses

 private:
  static constexpr std::size_t sizes = 3;

  [[nodiscard]] double crude_cell(const std::vector<Point>& points, double cells) const;
  void count_cells(Job& job, MeshReader& reader, double crude, double cells);

  Box box_;
  // Logarithms of cell edges, ascending, and of the cells occupied, descending.
  std::array<double, sizes> edge_{}, occupied_{};
};

// The box of all finite positions, in one pass.
Box measure_box(Job& job, MeshReader& reader);

// Of the corners of all faces that have three finite ones, so of no vertex that no face uses. In
// one pass over the faces.
Box measure_box_of_faces(Job& job, MeshReader& reader);

// The box of all positions, but where some lie so far off that it is more than four times as long
// as that of most, or where there are only a few. Then a pass over the faces says which vertices
// they use, and only those count. `positions`: about how many there are (corners, without
// vertices).
Box measure_surface(Job& job, MeshReader& reader, std::uint64_t positions);

// The box of all positions but for a few that lie very far off, as a vertex at 0, 0, 0 among
// georeferenced ones: then that of the others, and some room. A function of the positions and their
// order in the file. `positions`: about how many there are, as above; 0: not known, then all count.
Box measure_box_of_most(Job& job, MeshReader& reader, std::uint64_t positions);

// The same, and one finite position out of many, in any order; none where it is not known how many
// there are.
struct MostPositions {
  Box box;
  std::vector<Point> picked;
};
MostPositions measure_most(Job& job, MeshReader& reader, std::uint64_t positions);

}  // namespace winnow
