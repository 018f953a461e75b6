#include "stitch/unfolded_mesh.hpp"

#include "base/memory_shares.hpp"
#include "stitch/tiles.hpp"
#include "stitch/unfolded_tile.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace winnow {

std::unique_ptr<VertexIndex> unfolded_vertices(Job& job, const StoredMesh& mesh,
                                               const ReferenceMesh& reference,
                                               const RefineSettings& settings,
                                               const RefineMemory& memory) {
  auto vertices = std::make_unique<VertexIndex>(job, memory.mesh);
  const std::uint64_t ratio = reference.mesh().face_count / mesh.face_count;
  const Tiles tiles(job, mesh, settings, memory);
  const UnfoldRules rules{settings.decimation.single, settings.unfolds_thoroughly};
  tiles.for_each<std::vector<IndexedVertex>>(
      0,
      [&](std::size_t number, std::vector<IndexedVertex>& moved) {
        Tile tile = tiles.load(number, {});
        job.progress.advance(tile.own_faces);
        moved = unfolded_vertices(std::move(tile), reference, ratio, rules);
      },
      [&](std::size_t, const std::vector<IndexedVertex>& moved) { vertices->append(moved); });
  vertices->finish();
  return vertices;
}

std::unique_ptr<VertexIndex> unfolded_vertices(Job& job, const StoredMesh& mesh,
                                               const StoredMesh& reference,
                                               const RefineSettings& settings,
                                               const RefineMemory& memory) {
  const ReferenceMesh near(job, reference, share::refine::boxes(memory.lists));
  return unfolded_vertices(job, mesh, near, settings, memory);
}

}  // namespace winnow
