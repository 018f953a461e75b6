#include "stitch/tile.hpp"

#include "io/sorted_list.hpp"
#include "io/spool_records.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace winnow {

namespace {

struct IncomingFace {
  std::uint32_t tile;
  FaceVertices vertices;

  static bool before(const IncomingFace& a, const IncomingFace& b) {
    return a.tile != b.tile ? a.tile < b.tile : a.vertices < b.vertices;
  }
  static bool combine(IncomingFace&, const IncomingFace&) { return false; }
};

}  // namespace

IncomingFaces::IncomingFaces(Job& job, const ClusteredMesh& mesh, const Tiling& tiling, std::uint64_t memory)
    : faces_(job, memory / 2), first_(tiling.tiles() + 1, 0) {
  if (tiling.tiles() == 1) {
    faces_.finish();
    return;
  }
  const Reservation reserved = job.budget.reserve(memory / 2, "sorting");
  SortedRuns<IncomingFace> runs(job);
  SortedList<IncomingFace> list(job, memory / 2, runs);
  std::size_t tile = 0;  // of the lowest vertices, which come in order
  SpoolCursor<FaceVertices> faces(job, *mesh.faces);
  for (FaceVertices face{}; faces.next(face);) {
    while (face[0] >= tiling.first_vertex(tile + 1)) ++tile;
    const std::uint64_t end = tiling.first_vertex(tile + 1);
    if (face[1] < end && face[2] < end) continue;
    ++seam_faces_;
    const std::size_t second = face[1] < end ? tile : tiling.tile_of(face[1]);
    const std::size_t third = face[2] < end ? tile : tiling.tile_of(face[2]);
    if (second != tile) list.add({static_cast<std::uint32_t>(second), face});
    if (third != tile && third != second) list.add({static_cast<std::uint32_t>(third), face});
  }
  list.sort();
  MergedCursor<IncomingFace> merged = merge<IncomingFace>({&list}, runs);
  Appender<FaceVertices> append(job, faces_);
  for (IncomingFace face{}; merged.next(face);) {
    ++first_[face.tile + 1];
    append.add(face.vertices);
  }
  append.flush();
  faces_.finish();
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

std::vector<FaceVertices> IncomingFaces::faces(std::size_t tile) const {
  return read_records<FaceVertices>(faces_, first_[tile], count(tile));
}

std::uint64_t Tile::memory(std::uint64_t vertices, std::uint64_t faces, std::size_t state_size) {
  return vertices * (sizeof(IndexedVertex) + state_size) + faces * sizeof(std::uint32_t) +
         TileMesh::memory(vertices, faces);
}

Tile load_tile(const RefinedMesh& whole, const Tiling& tiling, const IncomingFaces& incoming,
               std::size_t number, std::size_t state_size, std::size_t attributes) {
  Tile tile;
  tile.first_vertex = tiling.first_vertex(number);
  const std::uint64_t end = tiling.first_vertex(number + 1);
  tile.own_vertices = static_cast<VertexNumber>(end - tile.first_vertex);
  tile.own_faces = static_cast<FaceNumber>(tiling.first_face(number + 1) - tiling.first_face(number));
  tile.vertices =
      read_records<IndexedVertex>(whole.mesh.vertices->records(), tile.first_vertex, tile.own_vertices);
  tile.faces = read_records<FaceVertices>(*whole.mesh.faces, tiling.first_face(number), tile.own_faces);
  const std::vector<FaceVertices> more = incoming.faces(number);
  tile.faces.insert(tile.faces.end(), more.begin(), more.end());

  const auto own = [&](std::uint32_t v) { return v >= tile.first_vertex && v < end; };
  for (const FaceVertices& face : tile.faces) {
    for (const std::uint32_t v : face) {
      if (!own(v)) tile.others.push_back(v);
    }
  }
  std::sort(tile.others.begin(), tile.others.end());
  tile.others.erase(std::unique(tile.others.begin(), tile.others.end()), tile.others.end());

  const std::size_t vertices = tile.own_vertices + tile.others.size();
  tile.locked.assign(vertices, 0);
  std::fill(tile.locked.begin() + tile.own_vertices, tile.locked.end(), std::uint8_t{1});
  for (FaceVertices& face : tile.faces) {
    const bool seam = !(own(face[0]) && own(face[1]) && own(face[2]));
    for (std::uint32_t& v : face) {
      const auto other =
          own(v) ? tile.others.end() : std::lower_bound(tile.others.begin(), tile.others.end(), v);
      v = other == tile.others.end()
              ? static_cast<VertexNumber>(v - tile.first_vertex)
              : static_cast<VertexNumber>(tile.own_vertices + (other - tile.others.begin()));
      if (seam) tile.locked[v] = 1;
    }
  }

  tile.positions.reserve(vertices);
  for (const IndexedVertex& vertex : tile.vertices) tile.positions.push_back(vertex.position);
  if (!tile.others.empty()) {
    VertexIndex::Reader reader(*whole.mesh.vertices);
    for (const std::uint32_t v : tile.others) tile.positions.push_back(reader.at(v).position);
  }
  if (whole.state != nullptr) {
    tile.state.resize(vertices * state_size);
    whole.state->read(tile.first_vertex * state_size,
                      std::span(tile.state).first(std::size_t{tile.own_vertices} * state_size));
  }
  if (attributes > 0) {
    tile.attributes = read_records<double>(*whole.mesh.attributes, tile.first_vertex * attributes,
                                           std::uint64_t{tile.own_vertices} * attributes);
  }
  return tile;
}

CarriedValues carried_values(Tile& tile, std::size_t attributes) {
  if (attributes == 0) return {};
  std::vector<Point> positions;
  positions.reserve(tile.vertices.size());
  for (const IndexedVertex& vertex : tile.vertices) positions.push_back(vertex.position);
  return {attributes, std::move(positions), std::move(tile.attributes)};
}

}  // namespace winnow
