#include "run/write_mesh.hpp"

#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "run/attributes.hpp"

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
        encode(part.first, static_cast<std::size_t>(std::min(chunk, count - part.first)), part.bytes);
      },
      [&](const Chunk& part) {
        sink.write(part.bytes);
        job.progress.advance(chunk);
      });
}

MeshVertex finished(const IndexedVertex& vertex) {
  MeshVertex out{vertex.position, vertex.normal};
  const auto [x, y, z] = vertex.normal;
  const float length = std::sqrt(x * x + y * y + z * z);
  if (length > 0) out.normal = {x / length, y / length, z / length};
  return out;
}

}  // namespace

void write_mesh(Job& job, const ClusteredMesh& mesh, const MeshShape& shape, const MeshEncoder& encoder,
                ByteSink& sink) {
  const std::string header = encoder.header(shape);
  sink.write(std::as_bytes(std::span(header)));
  job.progress.begin("write", shape.vertices + shape.faces, "elements");
  if (!encoder.needs_corners()) {
    write_chunks(job, shape.vertices, sink,
                 [&](std::uint64_t first, std::size_t count, std::vector<std::byte>& bytes) {
                   std::vector<IndexedVertex> indexed(count);
                   mesh.vertices->records().read(first * sizeof(IndexedVertex),
                                                 std::as_writable_bytes(std::span(indexed)));
                   std::vector<MeshVertex> vertices(count);
                   std::transform(indexed.begin(), indexed.end(), vertices.begin(), finished);
                   const std::size_t carried = shape.attributes.size();
                   std::vector<double> attributes(carried * count);
                   if (carried > 0) {
                     mesh.attributes->read(first * carried * sizeof(double),
                                           std::as_writable_bytes(std::span(attributes)));
                   }
                   for (std::size_t i = 0; i < count && carried > 0; ++i) {
                     const std::span<double> values = std::span(attributes).subspan(i * carried, carried);
                     finish_attributes(shape.attributes, vertices[i].normal, values);
                     vertices[i].attributes = values;
                   }
                   encoder.vertices(shape, vertices, bytes);
                 });
  }
  PerSlot<VertexIndex::Reader> readers(job.threads,
                                       [&] { return std::make_unique<VertexIndex::Reader>(*mesh.vertices); });
  write_chunks(
      job, shape.faces, sink, [&](std::uint64_t first, std::size_t count, std::vector<std::byte>& bytes) {
        constexpr std::size_t size = 3 * sizeof(std::uint32_t);
        std::vector<std::uint32_t> numbers(3 * count);
        mesh.faces->read(first * size, std::as_writable_bytes(std::span(numbers)));
        std::vector<MeshFace> faces(count);
        for (std::size_t i = 0; i < count; ++i)
          faces[i].vertex = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
        std::vector<Corners> corners;
        if (encoder.needs_corners()) {
          VertexIndex::Reader& reader = readers.local();
          for (const MeshFace& face : faces) {
            corners.push_back({reader.at(face.vertex[0]).position, reader.at(face.vertex[1]).position,
                               reader.at(face.vertex[2]).position});
          }
        }
        encoder.faces(shape, faces, corners, bytes);
      });
}

}  // namespace winnow
