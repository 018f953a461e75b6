#include "run/result_sink.hpp"

#include <winnow/error.hpp>

#include "base/parallel.hpp"
#include "options/level_targets.hpp"
#include "run/attributes.hpp"
#include "run/write_blocks.hpp"
#include "write/formats.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <optional>
#include <span>
#include <utility>
#include <variant>
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
constexpr std::uint64_t face_bytes = 3 * sizeof(std::uint32_t);

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

// What the vertices of a mesh are stored in.
class Columns {
 public:
  Columns(Mesh& mesh, const MeshShape& shape, std::uint64_t vertices)
      : normals_(shape.normals ? 3 : 0) {
    const NumberType real = shape.double_positions ? NumberType::float64 : NumberType::float32;
    const std::uint64_t numbers = 3 * vertices;
    positions_ = shape.double_positions
                     ? column_of(mesh.positions.emplace<std::vector<double>>(), real, numbers)
                     : column_of(mesh.positions.emplace<std::vector<float>>(), real, numbers);
    for (std::size_t axis = 0; axis < normals_; ++axis) {
      columns_.push_back(
          add_attribute(mesh, std::string(normal_names.at(axis)), NumberType::float32, vertices));
    }
    for (const Attribute& attribute : shape.attributes)
      columns_.push_back(add_attribute(mesh, attribute.name, attribute.type, vertices));
  }

  void store(const FinishedVertices& part, std::uint64_t first) const {
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      const MeshVertex& vertex = part.vertices[i];
      for (std::size_t axis = 0; axis < 3; ++axis)
        positions_.store(3 * (first + i) + axis, vertex.position.at(axis));
      for (std::size_t axis = 0; axis < normals_; ++axis)
        columns_[axis].store(first + i, vertex.normal.at(axis));
      for (std::size_t k = normals_; k < columns_.size(); ++k)
        columns_[k].store(first + i, vertex.attributes[k - normals_]);
    }
  }
  // Of a vertex.
  [[nodiscard]] std::uint64_t bytes() const {
    std::uint64_t sum = 3 * size_of(positions_.type);
    for (const Column& column : columns_) sum += size_of(column.type);
    return sum;
  }

 private:
  std::size_t normals_;
  Column positions_{};
  std::vector<Column> columns_;  // of normals, then of attributes
};

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

FileSink::FileSink(Job& job, std::string name, const SimplifyOptions& options, const char* way_out)
    : job_(job),
      name_(std::move(name)),
      format_(format_written(options.to, name_, options.encoding)),
      encoder_(encoder_for_file(name_, options)),
      packing_(reserve_block(job, *encoder_, !wish_for(options, *encoder_).none())),
      sink_(job, name_, options.force, way_out) {
  if (!writes_text(options.to, name_, options.encoding)) sink_.refuse_terminal();
}

std::uint64_t FileSink::write(const OutputMesh& mesh, const MeshShape& shape) {
  write_mesh(job_, mesh, shape, *encoder_, sink_);
  sink_.flush_and_sync();
  return sink_.written();
}

MemorySink::MemorySink(Job& job, Mesh& mesh, const SimplifyOptions& options)
    : job_(job), mesh_(mesh), encoder_(encoder_for_memory(options)) {}

std::uint64_t MemorySink::write(const OutputMesh& mesh, const MeshShape& shape) {
  Mesh result;
  std::optional<Columns> columns;
  try {
    columns.emplace(result, shape, shape.vertices);
    result.faces.resize(3 * shape.faces);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::resources,
                "there is no memory for the result, which the budget does not count; ask for less");
  }
  job_.progress.begin("write", shape.vertices + shape.faces, "elements");
  in_chunks(job_, shape.vertices, [&](std::uint64_t first, std::size_t count) {
    columns->store(mesh.vertices(shape, first, count), first);
  });
  const std::unique_ptr<FaceStream> stream = mesh.faces();
  for (auto into = result.faces.begin(); into != result.faces.end();) {
    const std::vector<std::uint32_t> corners = stream->next(elements_at_once);
    into = std::copy(corners.begin(), corners.end(), into);
    job_.progress.advance(corners.size() / 3);
  }
  mesh_ = std::move(result);
  return columns->bytes() * shape.vertices + face_bytes * shape.faces;
}

FunctionSink::FunctionSink(Job& job, BatchSink take, const SimplifyOptions& options)
    : job_(job), take_(std::move(take)), encoder_(encoder_for_memory(options)) {
  if (!take_) throw Error(ErrorKind::usage, "the sink has no function that takes batches");
}

std::uint64_t FunctionSink::write(const OutputMesh& mesh, const MeshShape& shape) {
  job_.progress.begin("write", shape.vertices + shape.faces, "elements");
  std::uint64_t bytes = 0;
  const auto in_order = [&](std::uint64_t elements, const auto& fill) {
    for (std::uint64_t first = 0; first < elements; first += elements_at_once) {
      const std::size_t count = std::min(elements_at_once, elements - first);
      Mesh batch;
      bytes += count * fill(batch, first, count);
      take_(batch.view());
      job_.progress.advance(count);
    }
  };
  in_order(shape.vertices, [&](Mesh& batch, std::uint64_t first, std::size_t count) {
    const Columns columns(batch, shape, count);
    columns.store(mesh.vertices(shape, first, count), 0);
    return columns.bytes();
  });
  const std::unique_ptr<FaceStream> stream = mesh.faces();
  in_order(shape.faces, [&](Mesh& batch, std::uint64_t /*first*/, std::size_t count) {
    batch.faces = stream->next(count);
    return face_bytes;
  });
  return bytes;
}

void refuse_levels(const SimplifyOptions& options) {
  if (options.coarser.empty()) return;
  throw Error(ErrorKind::usage,
              "several targets give several meshes: ask for all of them with simplify_levels() or "
              "finish_meshes()");
}

ResultSinks open_sinks(Job& job, const MeshSink& sink, const SimplifyOptions& options) {
  struct Opener {
    Job& job;
    const SimplifyOptions& options;
    ResultSinks sinks;

    void operator()(const std::string& name) {
      for (const std::string& file : output_names(name, options))
        sinks.push_back(std::make_unique<FileSink>(job, file, options));
    }
    void operator()(Mesh* mesh) {
      refuse_levels(options);
      sinks.push_back(std::make_unique<MemorySink>(job, *mesh, options));
    }
    void operator()(std::vector<Mesh>* meshes) {
      meshes->assign(1 + options.coarser.size(), {});
      for (Mesh& mesh : *meshes) sinks.push_back(std::make_unique<MemorySink>(job, mesh, options));
    }
    void operator()(const BatchSink& batches) {
      refuse_levels(options);
      sinks.push_back(std::make_unique<FunctionSink>(job, batches, options));
    }
  };
  Opener opener{job, options, {}};
  std::visit(opener, sink.kind());
  return std::move(opener.sinks);
}

}  // namespace winnow
