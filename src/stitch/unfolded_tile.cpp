#include "stitch/unfolded_tile.hpp"

#include "decimate/unfold.hpp"
#include "stitch/smaller_mesh.hpp"

#include <algorithm>
#include <utility>

namespace winnow {

namespace {

// How often faces of the reference may be looked at, for each face of the tile and for each of the
// reference, in the mean. Surfaces take a part of that; among faces that lie criss-cross very many
// may be near.
constexpr std::uint64_t looks_a_face = 500;
constexpr std::uint64_t looks_a_reference_face = 100;

// A tile does not know all faces of a hub. So the hub's normal has to stay, and the vertices beside
// it, too.
void lock_beside_hubs(Tile& tile) {
  if (tile.hubs.empty()) return;
  for (const FaceVertices& face : tile.faces) {
    const bool at_hub = std::any_of(face.begin(), face.end(),
                                    [&](VertexNumber v) { return tile.locked[v] == fixed_hub; });
    for (const VertexNumber v : face) {
      if (at_hub && tile.locked[v] == free_vertex) tile.locked[v] = closed_vertex;
    }
  }
}

// Gives the tile's own vertices their positions, and those of changed faces new normals.
void take_positions(Tile& tile, const std::vector<VertexNumber>& moved) {
  std::vector<std::uint8_t> changed(tile.positions.size(), 0);
  std::vector<Point> normals(tile.positions.size(), Point{});
  for (const FaceVertices& face : tile.faces) {
    const bool changes = std::any_of(face.begin(), face.end(), [&](VertexNumber v) {
      return std::binary_search(moved.begin(), moved.end(), v);
    });
    const Point normal =
        doubled_area({tile.positions[face[0]], tile.positions[face[1]], tile.positions[face[2]]});
    for (const VertexNumber v : face) {
      changed[v] |= static_cast<std::uint8_t>(changes);
      normals[v] = normals[v] + normal;
    }
  }
  for (VertexNumber v = 0; v < tile.own_vertices; ++v) {
    tile.vertices[v].position = tile.positions[v];
    if (changed[v] != 0) tile.vertices[v].normal = normal_along(normals[v]);
  }
}

}  // namespace

std::vector<IndexedVertex> unfolded_vertices(Tile tile, const ReferenceMesh& reference,
                                             std::uint64_t reference_faces, bool single) {
  lock_beside_hubs(tile);
  const std::uint64_t looks = looks_a_face + looks_a_reference_face * reference_faces;
  ReferenceMesh::Reader reader(reference, looks * tile.faces.size());
  const Unfolded done = unfold(tile.positions, tile.faces, tile.locked, single, reader);
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
