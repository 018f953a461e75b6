// What keeps the faces that are left: kept boundaries, hubs, kept pieces, or the topology.
#include "stitch/blocked_faces.hpp"

#include "support/surfaces.hpp"
#include "support/tile_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

BlockedFaces blocked(const std::vector<Triangle>& triangles, const DecimationSettings& settings) {
  const TileMesh mesh = tile_of(triangles);
  Tile tile;
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) tile.positions.push_back(mesh.position(v));
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) tile.faces.push_back(mesh.face(f));
  tile.own_vertices = mesh.vertex_count();
  tile.own_faces = mesh.face_count();
  tile.locked.assign(tile.own_vertices, free_vertex);
  return blocked_faces(std::move(tile), settings);
}

}  // namespace

TEST_CASE("faces at a kept boundary are told apart from those inside") {
  DecimationSettings settings;
  CHECK(blocked(sheet(10), settings).topology == 200);
  settings.keep_boundaries = true;
  const BlockedFaces kept = blocked(sheet(10), settings);
  CHECK(kept.boundaries == 200 - 2 * 8 * 8);
  CHECK(kept.topology == 2 * 8 * 8);
  CHECK(kept.reasons() == std::vector{StoppedBy::topology, StoppedBy::boundaries});
}

TEST_CASE("faces at hubs are told") {
  // The poles have 80 faces each.
  const BlockedFaces hubs = blocked(ball(40), {});
  CHECK(hubs.hubs == 2 * 80);
  CHECK(hubs.topology == ball(40).size() - 160);
  CHECK(hubs.reasons() == std::vector{StoppedBy::topology});
}

TEST_CASE("small pieces that are kept are told, large ones are not") {
  DecimationSettings settings;
  std::vector<Triangle> faces = ball(10);
  const std::size_t large = faces.size();
  for (const Triangle& face : placed(ball(3), 1, {5, 0, 0})) faces.push_back(face);
  CHECK(blocked(faces, settings).pieces == 0);
  settings.keep_pieces = true;
  CHECK(blocked(faces, settings).pieces == faces.size() - large);
  CHECK(blocked(faces, settings).topology == large);
}

}  // namespace winnow
