#include "mesh/stored_mesh.hpp"

namespace winnow {

MeshMemory MeshMemory::divide(std::uint64_t memory) {
  constexpr std::uint64_t vertex = sizeof(IndexedVertex);
  constexpr std::uint64_t faces = 2 * MeshLayout::face_bytes();
  return {memory / (vertex + faces) * vertex, memory / (vertex + faces) * faces};
}

StoredMesh::StoredMesh(Job& job, const MeshLayout& planned, const MeshMemory& memory)
    : layout(planned) {
  const std::uint64_t each = memory.vertices / layout.vertex_bytes();
  vertices = std::make_unique<VertexIndex>(job, each * sizeof(IndexedVertex));
  if (layout.state > 0) state = std::make_unique<Spool>(job, each * layout.state);
  if (layout.attributes > 0)
    attributes = std::make_unique<Spool>(job, each * layout.attribute_bytes());
  faces = std::make_unique<Spool>(job, memory.faces);
}

void StoredMesh::append_vertices(std::span<const IndexedVertex> more,
                                 std::span<const std::byte> states,
                                 std::span<const double> numbers) {
  vertices->append(more);
  if (state != nullptr) state->append(states);
  if (attributes != nullptr) attributes->append(std::as_bytes(numbers));
}

void StoredMesh::finish_vertices() {
  vertices->finish();
  if (state != nullptr) state->finish();
  if (attributes != nullptr) attributes->finish();
}

void StoredMesh::append_faces(std::span<const FaceVertices> more) {
  append_records<FaceVertices>(*faces, more);
  face_count += more.size();
}

void StoredMesh::finish_faces() {
  faces->finish();
}

std::array<const Spool*, 4> StoredMesh::spools() const {
  return {&vertices->records(), state.get(), attributes.get(), faces.get()};
}

}  // namespace winnow
