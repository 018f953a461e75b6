// Moves the vertices of a tile to where its surface is nearest to samples of the original, in the
// least-squares sense (Hoppe et al. 1993, with the faces fixed).
#pragma once

#include "base/rounding.hpp"
#include "base/vector.hpp"
#include "fit/face_sums.hpp"
#include "mesh/face_vertices.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace winnow {

struct VertexFitSettings {
  bool single = true;           // positions are rounded to floats
  double least_cosine = 0;      // between the normals of a face before and after
  CoordinateRounding rounding;  // of the samples
  double far = 0;               // the largest distances of samples are about as large
  bool boundaries = false;      // edges with one face, or more than two, move as well
};

// Which corners of a face that moved have brought it farther from the original than before, or the
// original from it, and farther than `far`. The face comes first, then those that touch it.
using FartherCorners = std::function<std::array<bool, 3>(std::span<const Triangle> before,
                                                         std::span<const Triangle> after)>;

struct FittedVertices {
  std::vector<std::uint32_t> moved;  // ascending
  // By how much less the squared distances of all samples are together, along the normals of the
  // faces and where samples keep their places on them.
  double gain = 0;
};

// `locked`: not 0 for vertices that stay. Vertices also stay where an edge has one face or more
// than two (without `boundaries`), where a face has samples that all lie on it but for rounding,
// and where a face would turn too far or become a line. `turn` is called now and then.
FittedVertices fit_vertices(std::vector<Point>& positions, std::span<const FaceVertices> faces,
                            std::span<const FaceSums> sums, std::span<const std::uint8_t> locked,
                            const VertexFitSettings& settings, const FartherCorners& farther,
                            const std::function<void()>& turn);

// Bytes in use at most, besides the mesh and the sums.
std::uint64_t vertex_fit_memory(std::uint64_t vertices, std::uint64_t faces);

}  // namespace winnow
