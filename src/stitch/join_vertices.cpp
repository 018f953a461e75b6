#include "stitch/join_vertices.hpp"

#include "base/memory_shares.hpp"
#include "cluster/face_list.hpp"
#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"
#include "mesh/vertex_map.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace winnow {

namespace {

// Of level 0 each vertex is a cell, of level n + 1 those are whose keys differ in the last n bits
// alone.
constexpr unsigned levels = 65;
constexpr std::uint32_t unused = UINT32_MAX;

class VertexJoiner {
 public:
  VertexJoiner(Job& job, const StoredMesh& whole, std::uint64_t lists)
      : job_(job), mesh_(whole), lists_(lists), group_(whole.vertices->size()) {}

  static std::uint64_t memory(std::uint64_t vertices) {
    return 3 * sizeof(std::uint32_t) * vertices;
  }

  // Cells of `level` whose first vertex comes before `before` are part of one of the next level.
  std::uint64_t count(unsigned level, std::uint64_t before) {
    group(level, before);
    std::uint64_t faces = 0;
    for_each_face([&](const FaceVertices&) { ++faces; });
    return faces;
  }

  // As counted last.
  StoredMesh join(std::uint64_t memory) {
    std::vector<std::uint32_t> number(groups_, unused);
    for_each_face([&](const FaceVertices& face) {
      for (const std::uint32_t g : face) number[g] = 0;
    });
    StoredMesh out(job_, mesh_.layout, MeshMemory::divide(memory));
    out.rounding = mesh_.rounding;
    VertexIndex::Reader reader(*mesh_.vertices);
    std::vector<std::byte> state(mesh_.layout.state);
    std::vector<double> numbers(mesh_.layout.attributes);
    std::uint32_t next = 0;
    for (std::uint64_t first = 0; first < group_.size();) {
      const std::uint32_t g = group_[first];
      const auto begin = group_.begin() + static_cast<std::ptrdiff_t>(first);
      const auto count =
          static_cast<std::uint64_t>(std::upper_bound(begin, group_.end(), g) - begin);
      const std::uint64_t middle = first + (count - 1) / 2;
      first += count;
      if (number[g] == unused) continue;
      number[g] = next++;
      const IndexedVertex vertex = reader.at(middle);
      if (!state.empty()) mesh_.state->read(middle * state.size(), state);
      if (!numbers.empty())
        numbers = read_records<double>(*mesh_.attributes, middle * numbers.size(), numbers.size());
      out.append_vertices({&vertex, 1}, state, numbers);
    }
    out.finish_vertices();
    if (mesh_.map != nullptr) out.map = map_by(number, share::round::map(memory));
    for_each_face([&](const FaceVertices& face) {
      const FaceVertices renumbered{number[face[0]], number[face[1]], number[face[2]]};
      out.append_faces({&renumbered, 1});
    });
    out.finish_faces();
    return out;
  }

 private:
  // Where the vertices went, by the numbers of groups.
  std::unique_ptr<Spool> map_by(const std::vector<std::uint32_t>& number, std::uint64_t memory) {
    static_assert(unused == nowhere);
    Spool joined(job_, memory);
    Appender<Destination> append(job_, joined);
    for (const std::uint32_t g : group_) append.add(number[g]);
    append.flush();
    joined.finish();
    return composed(job_, *mesh_.map, joined, memory);
  }

  void group(unsigned level, std::uint64_t before) {
    const auto cell = [](CellKey key, unsigned of) { return of > 64 ? 0 : key >> (of - 1); };
    SpoolCursor<IndexedVertex> cursor(job_, mesh_.vertices->records());
    IndexedVertex vertex;
    CellKey last = 0;
    bool joins = false;  // the next level
    groups_ = 0;
    for (std::uint64_t v = 0; cursor.next(vertex); last = vertex.key, ++v) {
      const bool same = v > 0 && level > 0 && cell(vertex.key, level) == cell(last, level);
      if (!same) {
        const bool joined = std::exchange(joins, v < before);
        const bool beside =
            v > 0 && joined && joins && cell(vertex.key, level + 1) == cell(last, level + 1);
        if (!beside) ++groups_;
      }
      group_[v] = groups_ - 1;
    }
  }

  // Each once, the lowest number first, in ascending order.
  template <typename Each>
  void for_each_face(const Each& each) const {
    SortedRecords<CellFace> joined(job_, lists_);
    SpoolCursor<FaceVertices> cursor = mesh_.face_cursor(job_);
    for (FaceVertices face{}; cursor.next(face);) {
      const std::uint32_t a = group_[face[0]];
      const std::uint32_t b = group_[face[1]];
      const std::uint32_t c = group_[face[2]];
      if (a != b && a != c && b != c) joined.add(cell_face(a, b, c));
    }
    MergedCursor<CellFace> merged = joined.merged();
    for (CellFace face{}; merged.next(face);) {
      FaceVertices corner{};
      for (std::size_t i = 0; i < 3; ++i) corner[i] = static_cast<std::uint32_t>(face.cell[i]);
      if (face.against > face.along) std::swap(corner[1], corner[2]);
      each(corner);
    }
  }

  Job& job_;
  const StoredMesh& mesh_;
  std::uint64_t lists_;
  std::vector<std::uint32_t> group_;  // of each vertex
  std::uint32_t groups_ = 0;
};

}  // namespace

bool join_vertices(Job& job, StoredMesh& whole, std::uint64_t faces, std::uint64_t lists,
                   std::uint64_t memory) {
  const std::uint64_t vertices = whole.vertices->size();
  const Reservation reserved = job.budget.try_reserve(VertexJoiner::memory(vertices));
  if (!reserved) return false;
  VertexJoiner joiner(job, whole, lists);
  // The coarser, the fewer.
  unsigned fine = 0;
  unsigned coarse = levels;
  while (coarse - fine > 1) {
    const unsigned middle = (fine + coarse) / 2;
    (joiner.count(middle, 0) > faces ? fine : coarse) = middle;
  }
  std::uint64_t too_few = 0;
  std::uint64_t enough = vertices;
  while (enough - too_few > 1) {
    const std::uint64_t middle = too_few + (enough - too_few) / 2;
    (joiner.count(fine, middle) > faces ? too_few : enough) = middle;
  }
  if (joiner.count(fine, enough) == 0) return false;
  whole = joiner.join(memory);
  return true;
}

}  // namespace winnow
