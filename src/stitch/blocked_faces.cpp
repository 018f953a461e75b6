#include "stitch/blocked_faces.hpp"

#include "decimate/legality.hpp"
#include "decimate/piece.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace winnow {

namespace {

// One face in so many makes a reason.
constexpr std::uint64_t least_part = 8;

// What keeps the faces of a vertex.
enum Keeper : std::uint8_t { nothing_else = 0, kept_border = 1, hub_beside = 2, small_piece = 4 };

}  // namespace

BlockedFaces blocked_faces(Tile tile, const DecimationSettings& settings) {
  std::vector<std::uint8_t> keeper(tile.locked.size(), nothing_else);
  for (std::size_t v = 0; v < keeper.size(); ++v) {
    if (tile.locked[v] == fixed_hub) keeper[v] = hub_beside;
    // Locked is what this tiling locks. A small piece across its borders is one as far as it is
    // known.
    tile.locked[v] = free_vertex;
  }
  TileMesh mesh(std::move(tile.positions), std::move(tile.faces), std::move(tile.locked));
  Legality legality(mesh, 0);
  Piece piece;
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.hub(v)) keeper[v] |= hub_beside;
    // Of vertices of other tiles not all faces are known.
    if (v >= tile.own_vertices) continue;
    if (settings.keep_boundaries && legality.at_boundary(v)) keeper[v] |= kept_border;
    if (settings.keep_pieces && (keeper[v] & small_piece) == 0 && piece.find(mesh, v)) {
      for (const VertexNumber w : piece.vertices) keeper[w] |= small_piece;
    }
  }
  BlockedFaces blocked;
  for (FaceNumber f = 0; f < tile.own_faces; ++f) {
    const auto [a, b, c] = mesh.face(f);
    const unsigned all = keeper[a] | keeper[b] | keeper[c];
    if ((all & kept_border) != 0) {
      ++blocked.boundaries;
    } else if ((all & hub_beside) != 0) {
      ++blocked.hubs;
    } else if ((all & small_piece) != 0) {
      ++blocked.pieces;
    } else {
      ++blocked.topology;
    }
  }
  return blocked;
}

std::vector<StoppedBy> BlockedFaces::reasons() const {
  std::vector<std::pair<std::uint64_t, StoppedBy>> counts{{topology, StoppedBy::topology},
                                                          {boundaries, StoppedBy::boundaries},
                                                          {hubs, StoppedBy::hubs},
                                                          {pieces, StoppedBy::pieces}};
  std::stable_sort(counts.begin(), counts.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  const std::uint64_t all = topology + boundaries + hubs + pieces;
  std::vector<StoppedBy> reasons;
  for (const auto& [faces, reason] : counts) {
    if (reasons.empty() || faces > all / least_part) reasons.push_back(reason);
  }
  return reasons;
}

}  // namespace winnow
