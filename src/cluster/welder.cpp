#include "cluster/welder.hpp"

#include <winnow/error.hpp>

#include "base/per_slot.hpp"
#include "base/rounding.hpp"
#include "base/text.hpp"
#include "cluster/resolution.hpp"
#include "cluster/two_sided.hpp"
#include "cluster/weld_lattice.hpp"
#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"
#include "read/for_each_batch.hpp"

#include <algorithm>

namespace winnow {

namespace {

// All faces of three vertices, whose numbers ascend. For each sense, along that order (an even
// permutation of it) and against it: how many faces have it, and the number of the first one in the
// input (low 32 bits).
struct WeldedFaces {
  std::array<std::uint32_t, 3> vertex;
  std::array<std::uint32_t, 2> count;  // at most 2^32 - 1
  std::array<std::uint32_t, 2> first;

  static bool before(const WeldedFaces& a, const WeldedFaces& b) {
    if (a.vertex[0] != b.vertex[0]) return a.vertex[0] < b.vertex[0];
    if (a.vertex[1] != b.vertex[1]) return a.vertex[1] < b.vertex[1];
    return a.vertex[2] < b.vertex[2];
  }
  static bool combine(WeldedFaces& into, const WeldedFaces& from) {
    for (std::size_t sense = 0; sense < 2; ++sense) {
      const std::uint64_t sum = std::uint64_t{into.count[sense]} + from.count[sense];
      into.count[sense] = static_cast<std::uint32_t>(std::min<std::uint64_t>(sum, UINT32_MAX));
      into.first[sense] = std::min(into.first[sense], from.first[sense]);
    }
    return true;
  }

  [[nodiscard]] bool balanced() const { return count[0] == count[1]; }
  [[nodiscard]] bool against() const {
    return balanced() ? first[1] < first[0] : count[0] < count[1];
  }
};

WeldedFaces welded_face(const std::array<std::uint64_t, 3>& number, std::uint32_t face) {
  WeldedFaces out{};
  std::copy(number.begin(), number.end(), out.vertex.begin());
  // Each exchange mirrors the face.
  std::size_t sense = 0;
  const auto order = [&](std::size_t low, std::size_t high) {
    if (out.vertex[high] > out.vertex[low]) return;
    std::swap(out.vertex[low], out.vertex[high]);
    sense = 1 - sense;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  out.count[sense] = 1;
  out.first.fill(UINT32_MAX);
  out.first[sense] = face;
  return out;
}

void weld_vertices(Job& job, MeshReader& reader, const Grid& grid, const WeldMemory& memory,
                   ClusteredMesh& mesh) {
  job.progress.begin("weld", reader.facts().vertices.value_or(0), "positions");
  ThreadedRecords<KeyedPosition> points(job, memory.lists);
  for_each_position_batch(job, reader, [&](const PositionView& view) {
    SortedList<KeyedPosition>& list = points.local();
    for (std::size_t i = 0; i < view.count; ++i) {
      const Point p = without_minus_zero({view.axis[0][i], view.axis[1][i], view.axis[2][i]});
      if (finite(p)) list.add({key_of(grid, p), p});
    }
  });
  MergedCursor<KeyedPosition> merged = points.merged();
  mesh.vertices = std::make_unique<VertexIndex>(job, memory.vertices);
  Appender<IndexedVertex, VertexIndex> append(job, *mesh.vertices);
  for (KeyedPosition point; merged.next(point);) {
    IndexedVertex vertex;
    vertex.key = point.key;
    vertex.position = point.position;
    append.add(vertex);
  }
  append.flush();
  mesh.vertices->finish();
  if (mesh.vertices->size() > UINT32_MAX) {
    throw Error(ErrorKind::failed, "the input has " + grouped(mesh.vertices->size()) +
                                       " different positions, more than one mesh can number; "
                                       "winnow simplify `detail` 6 clusters them");
  }
  mesh.cells = mesh.vertices->size();
}

// Two-sided faces go to `sided`, too.
void collect_faces(Job& job, RecordCursor<WeldedFaces>& faces, double rounding,
                   std::uint64_t memory, Spool& sided, ClusteredMesh& mesh) {
  mesh.faces = std::make_unique<Spool>(job, memory);
  Appender<std::array<std::uint32_t, 3>> append(job, *mesh.faces);
  Appender<TwoSidedFace> append_sided(job, sided);
  VertexIndex::Reader vertices(*mesh.vertices);
  const auto has_area = [&](const std::array<std::uint32_t, 3>& face) {
    Triangle corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = vertices.at(face[i]).position;
    return !thinner_than_rounding(corners, doubled_area(corners), rounding);
  };
  std::uint64_t seen = 0;
  for (WeldedFaces face; faces.next(face);) {
    if (++seen % chunk_records == 0) job.progress.check_cancelled();
    if (face.balanced() && !has_area(face.vertex)) {
      mesh.flat_pairs += face.count[0];
      continue;
    }
    const auto [a, b, c] = face.vertex;
    if (face.balanced())
      append_sided.add({mesh.face_count, std::min(face.first[0], face.first[1])});
    append.add(face.against() ? std::array{a, c, b} : face.vertex);
    mesh.fused += std::min(face.count[0], face.count[1]);
    ++mesh.face_count;
  }
  append.flush();
  mesh.faces->finish();
  append_sided.flush();
  sided.finish();
}

std::unique_ptr<Spool> collect_attributes(Job& job, AttributeMeans& means,
                                          const CarriedAttributes& attributes, std::uint64_t memory,
                                          std::uint64_t vertices) {
  auto spool = std::make_unique<Spool>(job, memory);
  const std::unique_ptr<AttributeCursor> cursor = means.finish();
  const std::size_t carried = attributes.attributes.size();
  std::vector<double> chunk;
  for (std::uint64_t v = 0; v < vertices; ++v) {
    chunk.resize(chunk.size() + carried);
    cursor->find(v, std::span(chunk).last(carried));
    if (chunk.size() < carried * chunk_records && v + 1 < vertices) continue;
    spool->append(std::as_bytes(std::span(chunk)));
    chunk.clear();
    job.progress.check_cancelled();
  }
  spool->finish();
  return spool;
}

}  // namespace

ClusteredMesh weld(Job& job, MeshReader& reader, const WeldSettings& settings,
                   const WeldMemory& memory, std::uint64_t available, ClusterCounts& counts) {
  const CarriedAttributes& attributes = settings.attributes;
  ClusteredMesh mesh;
  const Box box = measure_box_of_most(job, reader, reader.facts().vertices.value_or(available));
  if (box.empty) return mesh;
  const Grid grid = lattice_over(box);
  weld_vertices(job, reader, grid, memory, mesh);

  job.progress.begin("join faces", reader.facts().faces.value_or(0), "faces");
  auto faces = std::make_unique<ThreadedRecords<WeldedFaces>>(job, memory.lists);
  std::unique_ptr<AttributeMeans> means;
  if (!attributes.empty())
    means = AttributeMeans::make(job, attributes, AttributeMeans::Keys::numbers, memory.attributes);
  struct Worker {
    explicit Worker(const VertexIndex& index) : vertices(index) {}
    VertexIndex::Reader vertices;
    ClusterCounts counts;
  };
  PerSlot<Worker> workers(job.threads, [&] { return std::make_unique<Worker>(*mesh.vertices); });
  reader.begin_faces();
  const auto stop = [&] { return means != nullptr && means->wants_to_spill(); };
  while (for_each_face_batch(
      job, reader,
      [&](const FaceBatch& batch) {
        Worker& worker = workers.local();
        SortedList<WeldedFaces>& list = faces->local();
        if (settings.area != nullptr) settings.area->add(batch);
        const GoodFaces good(batch);
        ClusterCounts here;
        here.faces = batch.count;
        here.bad = good.bad();
        here.cropped = good.cropped();
        here.first_bad = good.first_bad();
        worker.counts.add(here);
        for (const NumberedFace& face : good.faces()) {
          std::array<std::uint64_t, 3> number{};
          for (std::size_t i = 0; i < 3; ++i) {
            const Point p = without_minus_zero(face.corner[i]);
            number[i] = worker.vertices.find(key_of(grid, p), p);
            if (number[i] == VertexIndex::Reader::absent)
              throw Error(ErrorKind::bad_input, "the input was changed while it was read");
          }
          const std::size_t place = face.number - batch.first;
          list.add(welded_face(number, batch.number(place)));
          if (means != nullptr) means->add(batch, place, number);
        }
      },
      stop)) {
    means->spill();
  }
  for (const Worker* worker : workers.all()) counts.add(worker->counts);
  Spool sided(job, memory.faces / 16);
  {
    MergedCursor<WeldedFaces> merged = faces->merged();
    collect_faces(job, merged, coordinate_rounding(settings.single), memory.faces, sided, mesh);
  }
  faces.reset();
  agree_on_sides(job, sided, memory.lists, mesh);
  if (means != nullptr)
    mesh.attributes =
        collect_attributes(job, *means, attributes, memory.means, mesh.vertices->size());
  return mesh;
}

}  // namespace winnow
