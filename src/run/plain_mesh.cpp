#include "run/plain_mesh.hpp"

#include "base/per_slot.hpp"
#include "base/text.hpp"
#include "read/for_each_batch.hpp"
#include "read/good_faces.hpp"
#include "write/append.hpp"

#include <atomic>
#include <cstring>

namespace winnow {

namespace {

void read_vertices(Job& job, MeshReader& reader, const Point& instead, StoredMesh& mesh) {
  job.progress.begin("read vertices", reader.facts().vertices.value_or(0), "vertices");
  std::atomic<std::uint64_t> not_finite{0};
  std::vector<IndexedVertex> part;
  std::vector<std::byte> carried;
  const std::size_t attributes = reader.facts().choice.carried.size();
  const std::size_t size = sizeof(IndexedVertex) + attributes * sizeof(double);
  for_each_position_batch_in_order(
      job, reader,
      [&](const PositionView& view, BatchBytes& bytes) {
        std::vector<double> values;
        if (attributes > 0) reader.read_attributes(view, values);
        for (std::size_t i = 0; i < view.count; ++i) {
          IndexedVertex vertex;
          vertex.key = view.first + i;
          vertex.position = {view.axis[0][i], view.axis[1][i], view.axis[2][i]};
          if (!finite(vertex.position)) {
            vertex.position = instead;
            ++not_finite;
          }
          append(bytes, vertex);
          for (std::size_t k = 0; k < attributes; ++k) append(bytes, values[i * attributes + k]);
        }
      },
      [&](std::span<const std::byte> bytes) {
        part.resize(bytes.size() / size);
        carried.clear();
        for (IndexedVertex& vertex : part) {
          std::memcpy(&vertex, bytes.data(), sizeof vertex);
          const auto values = bytes.subspan(sizeof vertex, size - sizeof vertex);
          carried.insert(carried.end(), values.begin(), values.end());
          bytes = bytes.subspan(size);
        }
        mesh.vertices->append(part);
        if (attributes > 0) mesh.attributes->append(carried);
      });
  mesh.finish_vertices();
  if (not_finite == 0) return;
  job.note(grouped(not_finite) + (not_finite == 1 ? " vertex is" : " vertices are") +
           " not finite; written in its place: the first that is");
}

}  // namespace

StoredMesh plain_mesh(Job& job, MeshReader& reader, const MeshMemory& memory,
                      ClusterCounts& counts) {
  StoredMesh mesh(job, {0, reader.facts().choice.carried.size()}, memory);
  const auto first = reader.first_finite_position();
  if (!first) return mesh;
  read_vertices(job, reader, *first, mesh);

  job.progress.begin("read faces", reader.facts().faces.value_or(0), "faces");
  PerSlot<ClusterCounts> workers(job.threads, [] { return std::make_unique<ClusterCounts>(); });
  for_each_face_batch_in_order(
      job, reader,
      [&](const FaceBatch& batch, BatchBytes& bytes) {
        const GoodFaces good(batch);
        ClusterCounts here;
        here.faces = batch.count;
        here.bad = good.bad();
        here.first_bad = good.first_bad();
        workers.local().add(here);
        for (const NumberedFace& face : good.faces()) {
          for (const std::uint32_t* corner : batch.index)
            append(bytes, corner[face.number - batch.first]);
        }
      },
      [&](std::span<const std::byte> bytes) {
        mesh.faces->append(bytes);
        mesh.face_count += bytes.size() / MeshLayout::face_bytes();
      });
  mesh.finish_faces();
  for (const ClusterCounts* worker : workers.all()) counts.add(*worker);
  return mesh;
}

}  // namespace winnow
