#include "cluster/build_mesh.hpp"

#include <winnow/error.hpp>

#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "base/text.hpp"
#include "cluster/representative.hpp"
#include "io/spool_records.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace winnow {

namespace {

constexpr std::size_t chunk_cells = 2048;
constexpr std::size_t chunk_faces = 4096;

// Below this the mean of three cell normals says nothing about which side is out.
constexpr double shortest_normal = 0.1;

struct Triple {
  std::array<CellKey, 3> cell;   // in the order of the winding
  std::uint64_t along, against;  // faces that fell onto it
};

// One face for all that fell onto the same three cells: turned the way most of them were; as many
// on either side are a sheet folded onto itself, which keeps the order of the keys.
struct FusedFaces {
  std::vector<Triple> faces;
  std::uint64_t fused = 0;
};

std::uint32_t counted(std::uint64_t faces) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(faces, UINT32_MAX));
}

struct Winding {
  std::uint64_t along = 0, against = 0;
};

class FaceFuser {
 public:
  explicit FaceFuser(RecordCursor<CellFace>& faces) : faces_(faces) { more_ = faces_.next(next_); }

  FusedFaces chunk() {
    FusedFaces out;
    while (more_ && out.faces.size() < chunk_faces) {
      const std::array<CellKey, 3> cell = next_.cell;
      Winding winding;
      // Counts beyond 32 bits come as several records.
      for (; more_ && next_.cell == cell; more_ = faces_.next(next_)) {
        winding.along += next_.along;
        winding.against += next_.against;
      }
      out.fused += std::min(winding.along, winding.against);
      if (winding.along >= winding.against) {
        out.faces.push_back({cell, winding.along, winding.against});
      } else {
        out.faces.push_back({{cell[0], cell[2], cell[1]}, winding.against, winding.along});
      }
    }
    return out;
  }

 private:
  RecordCursor<CellFace>& faces_;
  CellFace next_{};
  bool more_ = false;
};

// Algorithm 4 of the grid paper: against the mean of its vertices' normals, a face shows its back.
bool shows_its_back(const std::array<IndexedVertex, 3>& corner) {
  std::array<double, 3> mean{};
  for (const IndexedVertex& vertex : corner) {
    // The normal that is written; where a cell's own normals nearly cancel it says nothing and
    // counts little.
    const auto [x, y, z] = vertex.normal;
    const float size = std::sqrt(x * x + y * y + z * z);
    const float divisor = size < shortest_normal ? 1.0F : size;
    for (std::size_t axis = 0; axis < 3; ++axis) mean[axis] += vertex.normal[axis] / divisor;
  }
  const double length = (mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]) / 9;
  if (length < shortest_normal * shortest_normal) return false;
  std::array<double, 3> u{};
  std::array<double, 3> v{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    u[axis] = corner[1].position[axis] - corner[0].position[axis];
    v[axis] = corner[2].position[axis] - corner[0].position[axis];
  }
  return (u[1] * v[2] - u[2] * v[1]) * mean[0] + (u[2] * v[0] - u[0] * v[2]) * mean[1] +
             (u[0] * v[1] - u[1] * v[0]) * mean[2] <
         0;
}

}  // namespace

template <typename Sum>
void build_vertices(Job& job, MergedCells<Sum> cells, const ClusterSettings& settings,
                    ClusterResult& result) {
  StoredMesh& mesh = result.mesh;
  const bool states = mesh.state != nullptr;
  const std::size_t carried = mesh.layout.attributes;
  Sum next{};
  bool more = cells.sums->next(next);
  BoundarySum boundary{};
  bool more_boundaries = cells.boundaries != nullptr && cells.boundaries->next(boundary);
  struct Chunk {
    std::vector<WholeCell> cells;
    std::vector<IndexedVertex> vertices;
    std::vector<CellState> states;
    std::vector<double> attributes;
    std::vector<CellKey> vanished;
  };
  pipeline<Chunk>(
      2 * std::size_t{job.threads},
      [&](Chunk& chunk) {
        chunk.cells.clear();
        chunk.attributes.clear();
        chunk.vanished.clear();
        while (more && chunk.cells.size() < chunk_cells) {
          WholeCell cell(next.key, settings.split);
          for (; more && next.key == cell.key(); more = cells.sums->next(next)) cell.add(next);
          for (; more_boundaries && boundary.cell <= cell.key();
               more_boundaries = cells.boundaries->next(boundary)) {
            if (boundary.cell == cell.key()) cell.add(boundary);
          }
          ++result.cells;
          if (!cell.used()) {
            if (result.vanished != nullptr) chunk.vanished.push_back(cell.key());
            continue;
          }
          chunk.cells.push_back(cell);
          if (cells.attributes == nullptr) continue;
          chunk.attributes.resize(chunk.attributes.size() + carried);
          cells.attributes->find(cell.key(), std::span(chunk.attributes).last(carried));
        }
        job.progress.check_cancelled();
        return more || !chunk.cells.empty() || !chunk.vanished.empty();
      },
      [&](Chunk& chunk) {
        chunk.vertices.clear();
        chunk.states.clear();
        for (const WholeCell& cell : chunk.cells) {
          chunk.vertices.push_back(cell.vertex(settings));
          if (states)
            chunk.states.push_back(cell.state(settings.grid, chunk.vertices.back().position));
        }
      },
      [&](const Chunk& chunk) {
        mesh.append_vertices(chunk.vertices, std::as_bytes(std::span(chunk.states)),
                             chunk.attributes);
        if (!chunk.vanished.empty()) append_records<CellKey>(*result.vanished, chunk.vanished);
      });
  mesh.finish_vertices();
  if (result.vanished != nullptr) result.vanished->finish();
  if (mesh.vertices->size() > UINT32_MAX) {
    throw Error(
        ErrorKind::failed,
        "the result has " + grouped(mesh.vertices->size()) +
            " vertices, more than output formats can count; choose larger cells or fewer faces");
  }
}

template void build_vertices<CellSum>(Job&, MergedCells<CellSum>, const ClusterSettings&,
                                      ClusterResult&);
template void build_vertices<QuadricCellSum>(Job&, MergedCells<QuadricCellSum>,
                                             const ClusterSettings&, ClusterResult&);

void build_faces(Job& job, RecordCursor<CellFace>& faces, bool turn, ClusterResult& result) {
  StoredMesh& mesh = result.mesh;
  FaceFuser fuser(faces);
  PerSlot<VertexIndex::Reader> readers(
      job.threads, [&] { return std::make_unique<VertexIndex::Reader>(*mesh.vertices); });
  std::atomic<std::uint64_t> turned{0};
  struct Chunk {
    std::vector<Triple> faces;
    std::vector<FaceVertices> numbers;
    std::vector<FusedFace> several;
  };
  pipeline<Chunk>(
      2 * std::size_t{job.threads},
      [&](Chunk& chunk) {
        FusedFaces fused = fuser.chunk();
        job.progress.check_cancelled();
        result.fused += fused.fused;
        chunk.faces = std::move(fused.faces);
        return !chunk.faces.empty();
      },
      [&](Chunk& chunk) {
        VertexIndex::Reader& reader = readers.local();
        chunk.numbers.clear();
        chunk.several.clear();
        std::uint64_t turned_here = 0;
        for (const Triple& triple : chunk.faces) {
          std::array<IndexedVertex, 3> corner;
          FaceVertices number{};
          for (std::size_t i = 0; i < 3; ++i) {
            const VertexIndex::Reader::Found& found = reader.find(triple.cell[i]);
            corner[i] = found.vertex;
            number[i] = static_cast<std::uint32_t>(found.number);
          }
          if (turn && shows_its_back(corner)) {
            std::swap(number[1], number[2]);
            ++turned_here;
          }
          chunk.numbers.push_back(number);
          if (result.several != nullptr && triple.along + triple.against > 1)
            chunk.several.push_back({number, counted(triple.along), counted(triple.against)});
        }
        turned += turned_here;
      },
      [&](const Chunk& chunk) {
        mesh.append_faces(chunk.numbers);
        if (!chunk.several.empty()) append_records<FusedFace>(*result.several, chunk.several);
      });
  mesh.finish_faces();
  if (result.several != nullptr) result.several->finish();
  result.turned = turned;
}

}  // namespace winnow
