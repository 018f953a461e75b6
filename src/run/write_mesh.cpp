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

struct Chunk {
  std::uint64_t first = 0;
  std::size_t count = 0;
  std::vector<std::uint32_t> corners;  // of faces
  std::vector<std::byte> bytes;
};

// Numbers 0 to `count` in chunks, in order: `fill` takes what is not asked for by several threads;
// `encode` appends a chunk's bytes, on any of these.
template <typename Fill, typename Encode>
void write_chunks(Job& job, std::uint64_t count, ByteSink& sink, Fill fill, Encode encode) {
  std::uint64_t next = 0;
  pipeline<Chunk>(
      2 * std::size_t{job.threads},
      [&](Chunk& part) {
        if (next == count) return false;
        part.first = next;
        part.count = static_cast<std::size_t>(std::min(chunk, count - next));
        next += part.count;
        fill(part);
        return true;
      },
      [&](Chunk& part) {
        part.bytes.clear();
        encode(part);
      },
      [&](const Chunk& part) {
        sink.write(part.bytes);
        job.progress.advance(chunk);
      });
}

class StoredFaces final : public FaceStream {
 public:
  explicit StoredFaces(const StoredMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] std::vector<std::uint32_t> next(std::size_t count) override {
    const std::uint64_t first = told_;
    told_ = std::min(mesh_.face_count, first + count);
    return faces_of(mesh_, first, told_ - first);
  }

 private:
  const StoredMesh& mesh_;
  std::uint64_t told_ = 0;
};

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

Box StoredOutput::box(Job& job) const {
  Box box;
  mesh_.vertices->records().for_each_part(
      sizeof(IndexedVertex), [&](std::span<const std::byte> part) {
        job.progress.check_cancelled();
        for (; !part.empty(); part = part.subspan(sizeof(IndexedVertex))) {
          IndexedVertex vertex;
          std::memcpy(&vertex, part.data(), sizeof vertex);
          box.add(vertex.position);
        }
      });
  return box;
}

std::vector<std::uint32_t> faces_of(const StoredMesh& mesh, std::uint64_t first,
                                    std::size_t count) {
  constexpr std::size_t size = 3 * sizeof(std::uint32_t);
  std::vector<std::uint32_t> numbers(3 * count);
  mesh.faces->read(first * size, std::as_writable_bytes(std::span(numbers)));
  return numbers;
}

std::unique_ptr<FaceStream> StoredOutput::faces() const {
  return std::make_unique<StoredFaces>(mesh_);
}

bool writes_doubles(const Encoding& encoding, bool input) {
  return encoding.positions == Positions::as_input ? input
                                                   : encoding.positions == Positions::doubles;
}

MeshShape shape_of(Job& job, const OutputMesh& mesh, const MeshEncoder& encoder, bool normals,
                   bool double_positions, bool exact, std::string comment) {
  MeshShape shape{mesh.vertex_count(), mesh.face_count(), normals, double_positions,
                  std::move(comment)};
  const bool rounded = exact && !(double_positions && encoder.holds_doubles());
  if (!rounded && !encoder.needs_survey()) return shape;
  const Box box = mesh.box(job);
  if (rounded) {
    check_floats(box);
    note_coarse_floats(job, box, shape.faces);
  }
  if (encoder.needs_survey()) shape.box = box;
  note_coarse_steps(job, box, shape.faces, encoder.position_error(shape));
  return shape;
}

FinishedVertices StoredOutput::vertices(const MeshShape& shape, std::uint64_t first,
                                        std::size_t count) const {
  return finished_vertices(mesh_.vertices->records(), mesh_.attributes.get(), shape, first, count);
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

void write_mesh(Job& job, const OutputMesh& mesh, const MeshShape& shape,
                const MeshEncoder& encoder, ByteSink& sink) {
  if (encoder.blocks() != nullptr)
    return write_blocks(job, mesh.stored(), shape, *encoder.blocks(), sink);
  const std::string header = encoder.header(shape);
  sink.write(std::as_bytes(std::span(header)));
  job.progress.begin("write", shape.vertices + shape.faces, "elements");
  if (!encoder.needs_corners()) {
    write_chunks(
        job, shape.vertices, sink, [](const Chunk& /*part*/) {},
        [&](Chunk& part) {
          encoder.vertices(shape, part.first, mesh.vertices(shape, part.first, part.count).vertices,
                           part.bytes);
        });
  }
  const VertexIndex* const index = encoder.needs_corners() ? mesh.stored().vertices.get() : nullptr;
  PerSlot<VertexIndex::Reader> readers(
      job.threads, [&] { return std::make_unique<VertexIndex::Reader>(*index); });
  const std::unique_ptr<FaceStream> stream = mesh.faces();
  write_chunks(
      job, shape.faces, sink, [&](Chunk& part) { part.corners = stream->next(part.count); },
      [&](Chunk& part) {
        std::vector<MeshFace> faces(part.count);
        const std::vector<std::uint32_t>& numbers = part.corners;
        for (std::size_t i = 0; i < part.count; ++i)
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
        encoder.faces(shape, part.first, faces, corners, part.bytes);
      });
  const std::string footer = encoder.footer(shape);
  sink.write(std::as_bytes(std::span(footer)));
}

}  // namespace winnow
