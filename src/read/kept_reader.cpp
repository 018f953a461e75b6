#include "read/kept_reader.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
namespace winnow {

void KeptMesh::add_vertices(std::span<const double> xyz, bool single) {
  if (xyz.size() / 3 > no_vertex - vertices_.size()) {
    throw Error(ErrorKind::bad_input,
                "'" + name_ + "' has more than " + grouped(no_vertex) + " vertices, which is not supported");
  }
  vertices_.keep(xyz);
  single_ = single_ && single;
}

void KeptMesh::add_polygon(std::span<const std::uint32_t> corners) {
  if (corners.size() == 3) return faces_.add(corners);
  if (corners.size() < 3) return faces_.add_degenerate();
  fan_.clear();
  for (std::size_t i = 2; i < corners.size(); ++i)
    fan_.insert(fan_.end(), {corners[0], corners[i - 1], corners[i]});
  faces_.add(fan_);
}

// On a coherent mesh the vertices, in doubles, take as much as the faces.
KeptReader::KeptReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                       const std::string& format, const Parse& parse)
    : IndexedReader(job, std::move(source), memory, memory.vertices / 2),
      faces_(job, memory.vertices * 3 / 8),
      numbers_(job, memory.vertices / 8) {
  facts_.format = format;
  if (!source_->compression().empty()) facts_.format += ", " + source_->compression();
  KeptMesh mesh(job, vertices_, faces_, numbers_, source_->name());
  vertices_.begin_keeping(true);
  job.progress.begin("read the mesh", source_->size().value_or(0), "bytes");
  parse(*source_, memory.batch_faces, mesh);
  vertices_.finish_keeping();
  if (mesh.single()) vertices_.give_floats();
  faces_.finish();
  numbers_.finish();
  facts_.vertices = vertices_.size();
  facts_.faces = faces_.size();
  facts_.double_positions = !mesh.single();
}

bool KeptReader::read_faces(std::uint64_t first, RawBatch& batch) const {
  faces_.read(first, memory_.batch_faces, batch);
  for (std::uint32_t& index : std::span(batch.indices).first(numbers_.used() ? batch.indices.size() : 0))
    index = numbers_.place_of(index);
  return batch.count > 0;
}

bool KeptReader::next_indices(RawBatch& batch) {
  read_faces(next_kept_, batch);
  next_kept_ += batch.count;
  return batch.count > 0;
}

bool KeptReader::sample_indices(double place, RawBatch& batch) {
  return read_faces(sample_begin(place, faces_.size()), batch);
}

}  // namespace winnow
