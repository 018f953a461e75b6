// A mesh of any size, in memory or in scratch: what passes from stage to stage.
#pragma once

#include "base/rounding.hpp"
#include "io/spool.hpp"
#include "io/spool_records.hpp"
#include "mesh/face_vertices.hpp"
#include "mesh/vertex_index.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace winnow {

// What stands beside each vertex.
struct MeshLayout {
  std::size_t state = 0;       // bytes that collapsing has to know of it
  std::size_t attributes = 0;  // numbers that it carries

  [[nodiscard]] std::size_t attribute_bytes() const { return attributes * sizeof(double); }
  [[nodiscard]] std::size_t vertex_bytes() const {
    return sizeof(IndexedVertex) + state + attribute_bytes();
  }
  [[nodiscard]] static constexpr std::size_t face_bytes() { return sizeof(FaceVertices); }
};

// How much of a mesh may be in memory.
struct MeshMemory {
  std::uint64_t vertices = 0;  // and what is beside them
  std::uint64_t faces = 0;

  // Of a surface, which has two faces a vertex.
  static MeshMemory divide(std::uint64_t memory);
};

// Vertices come in the order of their keys. Faces begin with their lowest vertex, and come in the
// order of that.
struct StoredMesh {
  StoredMesh() = default;
  // Without vertices and faces yet.
  StoredMesh(Job& job, const MeshLayout& planned, const MeshMemory& memory);

  MeshLayout layout;
  std::unique_ptr<VertexIndex> vertices;
  // Of each vertex the CellState of its cell, or what Decimation::save() wrote; or none.
  std::unique_ptr<Spool> state;
  std::unique_ptr<Spool> attributes;  // doubles; none where the layout has none
  std::unique_ptr<Spool> faces;
  std::uint64_t face_count = 0;
  std::optional<CoordinateRounding> rounding{};  // of the input's positions; only where welded
  // Only where asked for: where the vertices of the mesh that the first round began with went, a
  // Destination each; null where that is this one.
  std::unique_ptr<Spool> map{};

  // In the order of vertices. They are finished before the first face is looked for.
  void append_vertices(std::span<const IndexedVertex> more, std::span<const std::byte> states,
                       std::span<const double> numbers);
  void finish_vertices();
  void append_faces(std::span<const FaceVertices> more);
  void finish_faces();

  [[nodiscard]] FaceVertices face(std::uint64_t number) const {
    return read_record<FaceVertices>(*faces, number);
  }
  // `more`: how many will be added to them.
  [[nodiscard]] std::vector<FaceVertices> read_faces(std::uint64_t first, std::uint64_t count,
                                                     std::uint64_t more = 0) const {
    return read_records<FaceVertices>(*faces, first, count, more);
  }

  // One face after the other.
  [[nodiscard]] SpoolCursor<FaceVertices> face_cursor(const Job& job) const {
    return {job, *faces};
  }

  // Null where there is none.
  [[nodiscard]] std::array<const Spool*, 4> spools() const;
};

}  // namespace winnow
