// PLY files whose vertices carry more than a position, made from what `winnow generate` writes, and
// read again.
#pragma once

#include "base/number_type.hpp"
#include "base/vector.hpp"
#include "read/ply/header.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace winnow::test {

struct Column {
  std::string name;
  NumberType type;
  std::function<double(const Point&)>
      value;  // of a vertex at this position; then rounded to the type
};

struct AttributedMesh {
  std::vector<Point> positions;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::string> properties;  // "uchar red", in the order of the file, coordinates too
  std::map<std::string, std::vector<double>> columns;  // numbers of each vertex
};

// A mesh file of triangles: binary PLY, little-endian.
AttributedMesh read_attributed(const std::string& path);

// The vertices and faces of `mesh` with these columns behind the coordinates, which are floats.
void write_attributed(const std::string& path, const AttributedMesh& mesh,
                      const std::vector<Column>& columns, PlyForm form = PlyForm::little_endian);

// A scan of `winnow generate` of about so many faces; returns the mesh without columns.
AttributedMesh generated(const std::string& directory, std::uint64_t faces);

// A few columns of all kinds that vary over the scan.
std::vector<Column> usual_columns();

// The mean of a column over the surface, of `mean` of its numbers.
double mean_over_surface(const AttributedMesh& mesh, const std::string& column,
                         const std::function<double(double)>& mean);

}  // namespace winnow::test
