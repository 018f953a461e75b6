// A piece of the surface: all faces that hang together. A small one that no collapse can make
// smaller may go as a whole.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// A piece with more faces stays, so that looking at one takes no more time than a few collapses.
inline constexpr std::uint32_t most_piece_faces = 64;

struct Piece {
  std::vector<VertexNumber> vertices;
  std::vector<FaceNumber> faces;

  // The piece of `v`. False, and no piece, where it has more than most_piece_faces, or where a
  // vertex of it is locked, a hub, or refuses(vertex).
  template <typename Refuses>
  bool find(TileMesh& mesh, VertexNumber v, const Refuses& refuses) {
    vertices.clear();
    faces.clear();
    if (mesh.locked(v) || mesh.hub(v) || !mesh.has_faces(v)) return false;
    mesh.mark_anew();
    mesh.mark(v);
    vertices.push_back(v);
    std::uint64_t corners = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const VertexNumber at = vertices[i];
      corners += mesh.degree(at);
      if (corners > 3 * std::uint64_t{most_piece_faces}) return false;
      bool whole = true;
      mesh.for_each_corner(at, [&](FaceNumber f, VertexNumber w, VertexNumber x) {
        if (at < w && at < x) faces.push_back(f);
        for (const VertexNumber neighbour : {w, x}) {
          if (!whole || !mesh.mark(neighbour)) continue;
          vertices.push_back(neighbour);
          whole = !mesh.locked(neighbour) && !mesh.hub(neighbour) && !refuses(neighbour);
        }
      });
      if (!whole) return false;
    }
    return true;
  }
  bool find(TileMesh& mesh, VertexNumber v) {
    return find(mesh, v, [](VertexNumber) { return false; });
  }
};

// What is lost with a piece, if all of it went to its middle.
struct PieceLoss {
  double area = 0;
  double surface = 0;   // the integral of the squared distance from the middle
  double boundary = 0;  // the same along edges with one face, times their lengths
  double farthest = 0;  // the square of the distance of the farthest vertex from the middle

  // So many of a triangle that is no piece.
  void add(const Triangle& t, double times = 1) {
    const double size = times * length(doubled_area(t)) / 2;
    const Point ab = t[1] - t[0];
    const Point bc = t[2] - t[1];
    const Point ca = t[0] - t[2];
    area += size;
    surface += size * (dot(ab, ab) + dot(bc, bc) + dot(ca, ca)) / 36;
  }
};
PieceLoss loss_of(const TileMesh& mesh, const Piece& piece, const VertexPlaces& places);
inline PieceLoss loss_of(const TileMesh& mesh, const Piece& piece) {
  return loss_of(mesh, piece, mesh.places());
}

// Its handles; 0 where it is no surface.
std::uint64_t handles_of(const TileMesh& mesh, const Piece& piece);

// What was not kept of the surface's topology.
struct TopologyChanges {
  std::uint64_t pieces = 0;
  double area = 0;            // of these pieces, as they were when they went
  std::uint64_t handles = 0;  // of these pieces, and those that closed
  std::uint64_t holes = 0;    // boundary loops that closed

  void add(const TopologyChanges& more) {
    pieces += more.pieces;
    area += more.area;
    handles += more.handles;
    holes += more.holes;
  }
  void add_piece(const TileMesh& mesh, const Piece& piece) {
    ++pieces;
    area += loss_of(mesh, piece).area;
    handles += handles_of(mesh, piece);
  }
};

}  // namespace winnow
