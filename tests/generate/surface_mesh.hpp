// What the tests of generated surfaces share: a surface as arrays, its edges, and outputs as bytes.
#pragma once

#include <winnow/generate.hpp>

#include "base/vector.hpp"
#include "generate/surface.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace winnow {

inline constexpr std::array all_surfaces{Surface::scan, Surface::terrain, Surface::part};

inline GenerateOptions generate_options(Surface surface, std::uint64_t faces, std::uint32_t seed = 1) {
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

// A directory that goes with the test.
class TestDirectory {
 public:
  TestDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "winnow-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path_ = name;
  }
  ~TestDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TestDirectory(const TestDirectory&) = delete;
  TestDirectory& operator=(const TestDirectory&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] bool empty() const { return std::filesystem::is_empty(path_); }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The bytes that `options` make.
inline std::string generated(GenerateOptions options, Format format = Format::ply, unsigned threads = 1,
                             std::uint64_t memory = std::uint64_t{64} << 20) {
  const TestDirectory directory;
  Context context;
  context.threads = threads;
  context.memory = memory;
  options.to = format;
  generate(context, directory.file("mesh"), options);
  return bytes_of(directory.file("mesh"));
}

}  // namespace winnow
