#include "stitch/unfolded_tile.hpp"

#include "decimate/unfold.hpp"

#include <utility>

namespace winnow {

namespace {

// How often faces of the reference may be looked at, for each face of the tile and for each of the
// reference, in the mean. Surfaces take a part of that; among faces that lie criss-cross very many
// may be near.
constexpr std::uint64_t looks_a_face = 500;
constexpr std::uint64_t looks_a_reference_face = 100;
// So many times as often where all faces are looked at and not one in twelve. With less, a sequence
// whose parts lie close to each other ends before the last faces had their turn.
constexpr std::uint64_t thorough_looks = 32;

}  // namespace

std::vector<IndexedVertex> unfolded_vertices(Tile tile, const ReferenceMesh& reference,
                                             std::uint64_t reference_faces,
                                             const UnfoldRules& rules) {
  lock_beside_hubs(tile);
  const std::uint64_t looks = looks_a_face + looks_a_reference_face * reference_faces;
  const std::uint64_t times = rules.thorough ? thorough_looks : 1;
  ReferenceMesh::Reader reader(reference, times * looks * tile.faces.size());
  const Unfolded done = unfold(tile.positions, tile.faces, tile.locked, rules, reader);
  if (!done.moved.empty()) take_positions(tile, done.moved);
  return std::move(tile.vertices);
}

std::uint64_t unfolded_tile_memory(std::uint64_t vertices, std::uint64_t faces) {
  const std::uint64_t tile = vertices * (sizeof(IndexedVertex) + sizeof(Point) + 1) +
                             faces * (sizeof(FaceVertices) + sizeof(std::uint32_t));
  return tile + unfold_memory(vertices, faces, ReferenceMesh::Reader::most_faces()) +
         ReferenceMesh::Reader::memory();
}

}  // namespace winnow
