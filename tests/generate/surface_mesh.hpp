// What the tests of generated surfaces share: a surface as arrays, its edges, and outputs as bytes.
#pragma once

#include "base/vector.hpp"
#include "generate/generate.hpp"
#include "generate/surface.hpp"
#include "support/files.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace winnow {

inline constexpr std::array all_surfaces{Surface::scan, Surface::terrain, Surface::part};

inline GenerateOptions generate_options(Surface surface, std::uint64_t faces,
                                        std::uint32_t seed = 1) {
  GenerateOptions options;
  options.surface = surface;
  options.faces = faces;
  options.seed = seed;
  return options;
}

struct SurfaceMesh {
  std::vector<Point> points;
  std::vector<MeshFace> faces;
};

inline SurfaceMesh mesh_of(const GenerateOptions& options) {
  const auto surface = make_surface(options);
  SurfaceMesh mesh;
  std::vector<std::uint64_t> ids(surface->vertices());
  std::iota(ids.begin(), ids.end(), std::uint64_t{0});
  mesh.points.resize(ids.size());
  surface->positions(ids, mesh.points);
  ids.resize(surface->faces());
  std::iota(ids.begin(), ids.end(), std::uint64_t{0});
  mesh.faces.resize(ids.size());
  surface->corners(ids, mesh.faces);
  return mesh;
}

using DirectedEdge = std::pair<std::uint64_t, std::uint64_t>;

// How often faces run along each edge in each direction.
inline std::map<DirectedEdge, int> directed_edges(const SurfaceMesh& mesh) {
  std::map<DirectedEdge, int> edges;
  for (const MeshFace& face : mesh.faces) {
    for (std::size_t n = 0; n < 3; ++n) ++edges[{face.vertex[n], face.vertex[(n + 1) % 3]}];
  }
  return edges;
}

// The bytes that `options` make.
inline std::string generated(GenerateOptions options, Format format = Format::ply,
                             unsigned threads = 1, std::uint64_t memory = std::uint64_t{64} << 20) {
  const test::Directory directory;
  Context context;
  context.threads = threads;
  context.memory = memory;
  options.to = format;
  generate(context, directory.file("mesh"), options);
  return test::bytes_of_file(directory.file("mesh"));
}

}  // namespace winnow
