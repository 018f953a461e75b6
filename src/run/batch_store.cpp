#include "run/batch_store.hpp"

#include <winnow/error.hpp>

#include "base/memory_shares.hpp"
#include "base/number_type.hpp"
#include "io/spooled_source.hpp"
#include "read/view_arrays.hpp"
#include "run/plan.hpp"
#include "run/simplify_options.hpp"
#include "write/formats.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <string>
#include <utility>

namespace winnow {

namespace {

constexpr std::uint64_t rows_at_once = 4096;
constexpr std::size_t stl_record = 50;
constexpr std::size_t stl_normal = 12;

template <std::size_t Width>
const std::byte* row(const Rows<Width>& rows, std::uint64_t number) {
  return static_cast<const std::byte*>(rows.data()) + number * rows.stride();
}

// each(first, count) for parts of so many elements.
template <typename Each>
void in_parts(std::uint64_t elements, const Each& each) {
  for (std::uint64_t first = 0; first < elements; first += rows_at_once)
    each(first, std::min(rows_at_once, elements - first));
}

// What vertices, and what faces, may take.
std::uint64_t memory_of_part(const Job& job, const SimplifyOptions& options) {
  MemoryPlan::divide(job.budget.total(), job.budget.used(), job.threads, needs_of(options));
  const std::uint64_t needed = MemoryPlan::smallest_for(job.threads, needs_of(options));
  return share::left::added_mesh(job.budget.left() - needed);
}

}  // namespace

BatchStore::BatchStore(Job& job, const SimplifyOptions& options)
    : job_(job),
      vertices_(std::make_unique<Spool>(job, memory_of_part(job, options))),
      faces_(std::make_unique<Spool>(job, memory_of_part(job, options))) {}

void BatchStore::settle(const MeshView& batch, bool loose) {
  if (vertices_ == nullptr) throw Error(ErrorKind::usage, "the mesh was finished before");
  check_batch(batch);
  job_.progress.check_cancelled();
  if (loose_.value_or(loose) != loose)
    throw Error(ErrorKind::usage,
                "triangles of their own were added beside vertices and faces; keep to one of them");
  loose_ = loose;
  if (batch.positions.count() == 0) return;
  const bool doubles = batch.positions.type() == NumberType::float64;
  if (doubles_.value_or(doubles) != doubles)
    throw Error(ErrorKind::usage,
                "`positions` were added as floats and as doubles; keep to one of them");
  doubles_ = doubles;
  std::vector<Attribute> attributes = attributes_of(batch);
  const auto same = [](const Attribute& a, const Attribute& b) {
    return a.name == b.name && a.type == b.type;
  };
  if (attributes_ && !std::ranges::equal(*attributes_, attributes, same))
    throw Error(ErrorKind::usage, "`attributes` of all batches have the same names and types");
  attributes_ = std::move(attributes);
}

void BatchStore::add(const MeshView& batch) {
  settle(batch, false);
  keep_vertices(batch);
  keep_faces(batch.faces);
}

void BatchStore::add_triangles(const MeshView& batch) {
  settle(batch, true);
  if (batch.faces.count() > 0)
    throw Error(ErrorKind::usage, "`faces` has no meaning beside loose triangles");
  if (batch.positions.count() % 3 != 0)
    throw Error(ErrorKind::usage, "a triangle takes three `positions`");
  if (batch.positions.count() == 0) return;
  if (!*doubles_ && attributes_->empty()) {
    keep_records(batch.positions);
  } else {
    keep_own_faces(batch.positions.count() / 3);
    keep_vertices(batch);
  }
}

void BatchStore::keep_vertices(const MeshView& batch) {
  const Rows<3>& positions = batch.positions;
  if (positions.count() == 0) return;
  vertex_count_ += positions.count();
  if (vertex_count_ > UINT32_MAX) {
    throw Error(ErrorKind::usage,
                "more vertices were added than 32 bits count; add triangles of floats instead");
  }
  const std::size_t real = *doubles_ ? sizeof(double) : sizeof(float);
  std::size_t size = 3 * real;
  for (const Attribute& attribute : *attributes_) size += size_of(attribute.type);
  std::vector<std::byte> records;
  in_parts(positions.count(), [&](std::uint64_t first, std::uint64_t count) {
    records.resize(count * size);
    std::byte* out = records.data();
    for (std::uint64_t i = first; i < first + count; ++i) {
      std::memcpy(out, row(positions, i), 3 * real);
      out += 3 * real;
      for (std::size_t k = 0; k < attributes_->size(); ++k) {
        const std::size_t bytes = size_of((*attributes_)[k].type);
        std::memcpy(out, row(batch.attributes[k].values, i), bytes);
        out += bytes;
      }
    }
    vertices_->append(records);
    job_.progress.check_cancelled();
  });
}

// As records of a PLY.
void BatchStore::keep_faces(const Rows<3>& faces) {
  constexpr std::size_t numbers = 3 * sizeof(std::uint32_t);
  face_count_ += faces.count();
  std::vector<std::uint32_t> corners;
  std::vector<std::byte> records;
  in_parts(faces.count(), [&](std::uint64_t first, std::uint64_t count) {
    corners.resize(3 * count);
    load_faces(faces, first, count, corners.data());
    records.assign(count * (1 + numbers), std::byte{3});
    for (std::size_t i = 0; i < count; ++i)
      std::memcpy(records.data() + i * (1 + numbers) + 1, corners.data() + 3 * i, numbers);
    faces_->append(records);
    job_.progress.check_cancelled();
  });
}

void BatchStore::keep_own_faces(std::uint64_t count) {
  std::vector<std::uint32_t> own(3 * std::min(count, rows_at_once));
  in_parts(count, [&](std::uint64_t first, std::uint64_t part) {
    std::iota(own.begin(), own.end(), static_cast<std::uint32_t>(vertex_count_ + 3 * first));
    keep_faces(std::span(own).first(3 * part));
  });
}

// As records of an STL.
void BatchStore::keep_records(const Rows<3>& corners) {
  constexpr std::size_t position = 3 * sizeof(float);
  face_count_ += corners.count() / 3;
  std::vector<std::byte> records;
  in_parts(corners.count() / 3, [&](std::uint64_t first, std::uint64_t count) {
    records.assign(count * stl_record, std::byte{0});
    for (std::uint64_t i = 0; i < 3 * count; ++i) {
      std::memcpy(records.data() + i / 3 * stl_record + stl_normal + i % 3 * position,
                  row(corners, 3 * first + i), position);
    }
    faces_->append(records);
    job_.progress.check_cancelled();
  });
}

std::string BatchStore::head() const {
  if (loose_.value_or(false) && vertex_count_ == 0)
    return stl_output.make({})->header({.faces = face_count_});
  MeshShape shape{.vertices = vertex_count_,
                  .faces = face_count_,
                  .double_positions = doubles_.value_or(false)};
  if (attributes_) shape.attributes = *attributes_;
  return ply_output.make({})->header(shape);
}

std::unique_ptr<ByteSource> BatchStore::finish() {
  std::vector<std::unique_ptr<Spool>> spools;
  for (std::unique_ptr<Spool>* spool : {&vertices_, &faces_}) {
    if (*spool == nullptr) throw Error(ErrorKind::usage, "the mesh was finished before");
    (*spool)->finish();
    spools.push_back(std::move(*spool));
  }
  if (face_count_ == 0) throw Error(ErrorKind::bad_input, "no face was added");
  return spooled_source("what was added", head(), std::move(spools));
}

}  // namespace winnow
