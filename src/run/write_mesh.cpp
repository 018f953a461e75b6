#include "run/write_mesh.hpp"

#include <winnow/error.hpp>

#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "io/spool_records.hpp"
#include "run/attributes.hpp"
#include "run/write_blocks.hpp"
#include "write/coarse_floats.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace winnow {

namespace {

constexpr std::uint64_t chunk = 8192;  // vertices or faces encoded at once

// Numbers 0 to `count` in chunks: `encode` appends a chunk's bytes, from several threads.
template <typename Encode>
void write_chunks(Job& job, std::uint64_t count, ByteSink& sink, Encode encode) {
  struct Chunk {
    std::uint64_t first = 0;
    std::vector<std::byte> bytes;
  };
  std::uint64_t next = 0;
  pipeline<Chunk>(
      2 * std::size_t{job.threads},
      [&](Chunk& part) {
        part.first = next;
        next += chunk;
        return part.first < count;
      },
      [&](Chunk& part) {
        part.bytes.clear();
        encode(part.first, static_cast<std::size_t>(std::min(chunk, count - part.first)),
               part.bytes);
      },
      [&](const Chunk& part) {
        sink.write(part.bytes);
        job.progress.advance(chunk);
      });
}

Box box_of(Job& job, const VertexIndex& vertices) {
  Box box;
  vertices.records().for_each_part(sizeof(IndexedVertex), [&](std::span<const std::byte> part) {
    job.progress.check_cancelled();
    for (; !part.empty(); part = part.subspan(sizeof(IndexedVertex))) {
      IndexedVertex vertex;
      std::memcpy(&vertex, part.data(), sizeof vertex);
      box.add(vertex.position);
    }
  });
  return box;
}

}  // namespace

void check_finite(const Point& position) {
  if (finite(position)) return;
  throw Error(
      ErrorKind::bad_input,
      "a vertex of the result is not finite: the coordinates of the input are too large to compute "
      "with; scale the model down");
}

MeshVertex finished(const IndexedVertex& vertex) {
  check_finite(vertex.position);
  MeshVertex out{vertex.position, vertex.normal};
  const auto [x, y, z] = vertex.normal;
  const float length = std::sqrt(x * x + y * y + z * z);
  if (length > 0) out.normal = {x / length, y / length, z / length};
  return out;
}

std::vector<std::uint32_t> faces_of(const StoredMesh& mesh, std::uint64_t first,
                                    std::size_t count) {
  constexpr std::size_t size = 3 * sizeof(std::uint32_t);
  std::vector<std::uint32_t> numbers(3 * count);
  mesh.faces->read(first * size, std::as_writable_bytes(std::span(numbers)));
  return numbers;
}

bool writes_doubles(const Encoding& encoding, bool input) {
  return encoding.positions == Positions::as_input ? input
                                                   : encoding.positions == Positions::doubles;
}

MeshShape shape_of(Job& job, const StoredMesh& mesh, const MeshEncoder& encoder, bool normals,
                   bool double_positions, bool exact, std::string comment) {
  MeshShape shape{mesh.vertices->size(), mesh.face_count, normals, double_positions,
                  std::move(comment)};
  const bool rounded = exact && !(double_positions && encoder.holds_doubles());
  if (!rounded && !encoder.needs_survey()) return shape;
  const Box box = box_of(job, *mesh.vertices);
  if (rounded) {
    check_floats(box);
    note_coarse_floats(job, box, mesh.face_count);
  }
  if (encoder.needs_survey()) shape.box = box;
  note_coarse_steps(job, box, mesh.face_count, encoder.position_error(shape));
  return shape;
}

FinishedVertices finished_vertices(const StoredMesh& mesh, const MeshShape& shape,
                                   std::uint64_t first, std::size_t count) {
  return finished_vertices(mesh.vertices->records(), mesh.attributes.get(), shape, first, count);
}

FinishedVertices finished_vertices(const Spool& vertices, const Spool* attributes,
                                   const MeshShape& shape, std::uint64_t first, std::size_t count) {
  const std::vector<IndexedVertex> indexed = read_records<IndexedVertex>(vertices, first, count);
  FinishedVertices out;
  out.vertices.resize(count);
  std::transform(indexed.begin(), indexed.end(), out.vertices.begin(), finished);
  const std::size_t carried = shape.attributes.size();
  if (carried == 0) return out;
  out.attributes.resize(carried * count);
  attributes->read(first * carried * sizeof(double),
                   std::as_writable_bytes(std::span(out.attributes)));
  for (std::size_t i = 0; i < count; ++i) {
    finish_attributes(shape, std::span(out.attributes).subspan(i * carried, carried),
                      out.vertices[i]);
  }
  return out;
}

void write_mesh(Job& job, const StoredMesh& mesh, const MeshShape& shape,
                const MeshEncoder& encoder, ByteSink& sink) {
  if (encoder.blocks() != nullptr) return write_blocks(job, mesh, shape, *encoder.blocks(), sink);
  const std::string header = encoder.header(shape);
  sink.write(std::as_bytes(std::span(header)));
  job.progress.begin("write", shape.vertices + shape.faces, "elements");
  if (!encoder.needs_corners()) {
    write_chunks(job, shape.vertices, sink,
                 [&](std::uint64_t first, std::size_t count, std::vector<std::byte>& bytes) {
                   encoder.vertices(shape, first,
                                    finished_vertices(mesh, shape, first, count).vertices, bytes);
                 });
  }
  PerSlot<VertexIndex::Reader> readers(
      job.threads, [&] { return std::make_unique<VertexIndex::Reader>(*mesh.vertices); });
  write_chunks(job, shape.faces, sink,
               [&](std::uint64_t first, std::size_t count, std::vector<std::byte>& bytes) {
                 const std::vector<std::uint32_t> numbers = faces_of(mesh, first, count);
                 std::vector<MeshFace> faces(count);
                 for (std::size_t i = 0; i < count; ++i)
                   faces[i].vertex = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
                 std::vector<Corners> corners;
                 if (encoder.needs_corners()) {
                   VertexIndex::Reader& reader = readers.local();
                   for (const MeshFace& face : faces) {
                     corners.push_back({reader.at(face.vertex[0]).position,
                                        reader.at(face.vertex[1]).position,
                                        reader.at(face.vertex[2]).position});
                     for (const Point& corner : corners.back()) check_finite(corner);
                   }
                 }
                 encoder.faces(shape, first, faces, corners, bytes);
               });
  const std::string footer = encoder.footer(shape);
  sink.write(std::as_bytes(std::span(footer)));
}

}  // namespace winnow
