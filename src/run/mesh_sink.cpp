#include "run/mesh_sink.hpp"

#include <winnow/error.hpp>

#include "base/parallel.hpp"
#include "options/level_targets.hpp"
#include "run/attributes.hpp"
#include "run/write_blocks.hpp"
#include "write/formats.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

namespace {

std::unique_ptr<MeshEncoder> encoder_for_file(const std::string& name,
                                              const SimplifyOptions& options) {
  std::unique_ptr<MeshEncoder> encoder = make_encoder(options.to, name, options.encoding);
  if (options.target.faces())
    (void)encoder->header({.faces = *options.target.faces()});  // refuses what it cannot count
  return encoder;
}

std::unique_ptr<MeshEncoder> encoder_for_memory(const SimplifyOptions& options) {
  if (options.to != Format::automatic || options.encoding.ascii) {
    throw Error(ErrorKind::usage, "`to` and `ascii` are for files; a mesh in memory has no format");
  }
  return make_encoder(Format::ply, {}, options.encoding);
}

constexpr std::uint64_t elements_at_once = 8192;

// The numbers of one element of a mesh, as bytes, side by side.
struct Column {
  std::byte* data;
  NumberType type;

  void store(std::uint64_t at, double value) const {
    store_rounded(value, type, data + at * size_of(type));
  }
};

template <typename Number>
Column column_of(std::vector<Number>& numbers, NumberType type, std::uint64_t count) {
  numbers.resize(count);
  return {std::as_writable_bytes(std::span(numbers)).data(), type};
}

Column add_attribute(Mesh& mesh, const std::string& name, NumberType type, std::uint64_t count) {
  Mesh::Attribute& attribute = mesh.attributes.emplace_back();
  attribute.name = name;
  return with_type(type, [&]<typename Number>(Number) {
    return column_of(attribute.values.emplace<std::vector<Number>>(), type, count);
  });
}

// work(first, count) for parts of so many elements, from all threads.
template <typename Work>
void in_chunks(Job& job, std::uint64_t elements, const Work& work) {
  parallel_for((elements + elements_at_once - 1) / elements_at_once, [&](std::size_t chunk) {
    const std::uint64_t first = chunk * elements_at_once;
    const std::size_t count = std::min(elements_at_once, elements - first);
    work(first, count);
    job.progress.advance(count);
  });
}

}  // namespace

void finish(const MeshSinks& sinks) {
  if (sinks.size() == 1) return sinks.front()->finish();
  std::size_t finished = 0;
  try {
    for (; finished < sinks.size(); ++finished) sinks[finished]->finish_for_now();
  } catch (...) {
    while (finished > 0) sinks[--finished]->take_back();
    throw;
  }
}

MeshSinks sinks_to(Job& job, const std::string& output, const SimplifyOptions& options) {
  MeshSinks sinks;
  for (const std::string& name : output_names(output, options))
    sinks.push_back(std::make_unique<FileSink>(job, name, options));
  return sinks;
}

MeshSinks sinks_into(Job& job, std::vector<Mesh>& meshes, const SimplifyOptions& options) {
  MeshSinks sinks;
  for (Mesh& mesh : meshes) sinks.push_back(std::make_unique<MemorySink>(job, mesh, options));
  return sinks;
}

void refuse_levels(const SimplifyOptions& options) {
  if (options.coarser.empty()) return;
  throw Error(ErrorKind::usage,
              "several targets give several meshes: ask for all of them with simplify_levels() or "
              "finish_meshes()");
}

FileSink::FileSink(Job& job, std::string name, const SimplifyOptions& options, const char* way_out)
    : job_(job),
      name_(std::move(name)),
      format_(format_written(options.to, name_, options.encoding)),
      encoder_(encoder_for_file(name_, options)),
      packing_(reserve_block(job, *encoder_, !wish_for(options, *encoder_).none())),
      sink_(job, name_, options.force, way_out) {
  if (!writes_text(options.to, name_, options.encoding)) sink_.refuse_terminal();
}

std::uint64_t FileSink::write(const StoredMesh& mesh, const MeshShape& shape) {
  write_mesh(job_, mesh, shape, *encoder_, sink_);
  sink_.flush_and_sync();
  return sink_.written();
}

MemorySink::MemorySink(Job& job, Mesh& mesh, const SimplifyOptions& options)
    : job_(job), mesh_(mesh), encoder_(encoder_for_memory(options)) {}

std::uint64_t MemorySink::write(const StoredMesh& mesh, const MeshShape& shape) {
  mesh_ = {};
  std::vector<Column> columns;  // of normals, then of attributes
  Column positions{};
  try {
    const NumberType real = shape.double_positions ? NumberType::float64 : NumberType::float32;
    const std::uint64_t numbers = 3 * shape.vertices;
    positions = shape.double_positions
                    ? column_of(mesh_.positions.emplace<std::vector<double>>(), real, numbers)
                    : column_of(mesh_.positions.emplace<std::vector<float>>(), real, numbers);
    for (std::size_t axis = 0; axis < 3 && shape.normals; ++axis) {
      columns.push_back(add_attribute(mesh_, std::string(normal_names.at(axis)),
                                      NumberType::float32, shape.vertices));
    }
    for (const Attribute& attribute : shape.attributes)
      columns.push_back(add_attribute(mesh_, attribute.name, attribute.type, shape.vertices));
    mesh_.faces.resize(3 * shape.faces);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::resources,
                "there is no memory for the result, which the budget does not count; ask for less");
  }
  job_.progress.begin("write", shape.vertices + shape.faces, "elements");
  const std::size_t normals = shape.normals ? 3 : 0;
  in_chunks(job_, shape.vertices, [&](std::uint64_t first, std::size_t count) {
    const FinishedVertices part = finished_vertices(mesh, shape, first, count);
    for (std::size_t i = 0; i < count; ++i) {
      const MeshVertex& vertex = part.vertices[i];
      for (std::size_t axis = 0; axis < 3; ++axis)
        positions.store(3 * (first + i) + axis, vertex.position.at(axis));
      for (std::size_t axis = 0; axis < normals; ++axis)
        columns[axis].store(first + i, vertex.normal.at(axis));
      for (std::size_t k = 0; k < shape.attributes.size(); ++k)
        columns[normals + k].store(first + i, vertex.attributes[k]);
    }
  });
  in_chunks(job_, shape.faces, [&](std::uint64_t first, std::size_t count) {
    const std::vector<std::uint32_t> corners = faces_of(mesh, first, count);
    std::copy(corners.begin(), corners.end(), mesh_.faces.begin() + std::ptrdiff_t(3 * first));
  });
  std::uint64_t bytes = size_of(positions.type) * 3 * shape.vertices + 12 * shape.faces;
  for (const Column& column : columns) bytes += size_of(column.type) * shape.vertices;
  return bytes;
}

}  // namespace winnow
