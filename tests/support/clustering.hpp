// Triangles clustered through the library, as plain lists.
#pragma once

#include "cluster/clusterer.hpp"
#include "cluster/welder.hpp"
#include "support/job.hpp"
#include "support/surfaces.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace winnow::test {

struct PlainMesh {
  std::vector<IndexedVertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::uint64_t cells = 0, turned = 0, fused = 0;
  ClusterCounts counts;
  std::uint64_t spilled = 0;  // bytes

  [[nodiscard]] Triangle triangle(std::size_t face) const;
};

// What must not change a result.
struct ClusterStyle {
  ClusterMemory memory{std::uint64_t{32} << 20, std::uint64_t{32} << 20, std::uint64_t{32} << 20,
                       std::uint64_t{32} << 20, 16};
  unsigned threads = 2;
  Random* batches = nullptr;  // of random sizes; else as large as they may be
  bool single = false;        // batches of floats, for corners that floats hold
  bool ask_to_spill = true;   // as the pipeline does; else the table has to see to it
};

// Vertices and faces of a result; the counts are the caller's.
PlainMesh plain(const StoredMesh& mesh);
// With what clustering or welding found.
PlainMesh plain(const ClusterResult& clustered);
PlainMesh plain(const WeldResult& welded);

// As it leaves the clusterer.
ClusterResult clustered(Job& job, const std::vector<Triangle>& faces,
                        const ClusterSettings& settings);

PlainMesh cluster(const std::vector<Triangle>& faces, const ClusterSettings& settings,
                  const ClusterStyle& style = {});

// Empty where both are the same to the bit.
std::string difference(const PlainMesh& a, const PlainMesh& b);

// The cell that holds a position, by the definition.
inline CellKey key_of(const Grid& grid, const Point& p) {
  return morton_key(static_cast<std::uint32_t>(grid.cell_of(p[0], 0)),
                    static_cast<std::uint32_t>(grid.cell_of(p[1], 1)),
                    static_cast<std::uint32_t>(grid.cell_of(p[2], 2)));
}

// Over the box of the faces, in cells of this edge.
ClusterSettings settings_over(const std::vector<Triangle>& faces, double cell,
                              Placement placement = Placement::mean);

}  // namespace winnow::test
