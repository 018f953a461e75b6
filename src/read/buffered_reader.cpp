#include "read/buffered_reader.hpp"

#include <winnow/error.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"

#include <algorithm>

namespace winnow {

void BufferedMesh::add_vertices(std::span<const double> xyz, bool single,
                                std::span<const double> attributes) {
  if (xyz.size() / 3 > no_vertex - vertices_.size()) {
    throw Error(ErrorKind::bad_input, "'" + name_ + "' has more than " + grouped(no_vertex) +
                                          " vertices, which is not supported");
  }
  vertices_.keep(xyz, attributes);
  single_ = single_ && single;
}

void BufferedMesh::pass_over(const std::string& what) {
  if (std::find(passed_over_.begin(), passed_over_.end(), what) == passed_over_.end())
    passed_over_.push_back(what);
}

// On a coherent mesh the vertices, in doubles, take as much as the faces.
BufferedReader::BufferedReader(Job& job, std::unique_ptr<ByteSource> source,
                               const ReaderMemory& memory, const AttributeRequest& wish,
                               const std::string& format, const AvailableAttributes& offer,
                               const Parse& parse)
    : IndexedReader(job, std::move(source), memory,
                    share::reading::buffered_vertices(memory.vertices)),
      faces_(job, share::reading::buffered_faces(memory.vertices)),
      numbers_(job, share::reading::buffered_numbers(memory.vertices)) {
  facts_.format = format;
  if (!source_->compression().empty()) facts_.format += ", " + source_->compression();
  facts_.offer = offer;
  facts_.choice = choose_attributes(wish, offer, source_->name());
  std::vector<bool> carried(offer.scalars.size());
  for (const std::size_t scalar : facts_.choice.scalar) carried[scalar] = true;
  BufferedMesh mesh(job, vertices_, faces_, numbers_, std::move(carried), source_->name());
  vertices_.begin_keeping(true, types_of(facts_.choice.carried));
  job.progress.begin("read the mesh", source_->size().value_or(0), "bytes");
  parse(*source_, memory.batch_faces, mesh);
  vertices_.finish_keeping();
  if (mesh.single()) vertices_.give_floats();
  faces_.finish();
  numbers_.finish();
  facts_.vertices = vertices_.size();
  facts_.points = mesh.points();
  facts_.faces = faces_.size();
  facts_.double_positions = !mesh.single();
  if (mesh.attributes_dropped()) {
    facts_.offer.scalars.clear();
    vertices_.drop_attributes();
    mesh.pass_over(colors_of_some);
  }
  std::string line;
  for (const Attribute& attribute : facts_.offer.scalars)
    line += (line.empty() ? "vertex: " : " ") + described(attribute);
  if (!line.empty()) facts_.attributes.push_back(line);
  facts_.attributes.insert(facts_.attributes.end(), mesh.passed_over().begin(),
                           mesh.passed_over().end());
  facts_.offer.unread = mesh.passed_over();
  facts_.choice = choose_attributes(wish, facts_.offer, source_->name());
}

bool BufferedReader::read_faces(std::uint64_t first, RawBatch& batch) {
  faces_.read(first, memory_.batch_faces, batch, grow_batch());
  if (numbers_.used()) numbers_.find(batch.indices);
  return batch.count > 0;
}

bool BufferedReader::next_indices(RawBatch& batch) {
  read_faces(next_kept_, batch);
  next_kept_ += batch.count;
  return batch.count > 0;
}

bool BufferedReader::sample_indices(double place, RawBatch& batch) {
  return read_faces(faces_.begin_of(sample_begin(place, faces_.size())), batch);
}

}  // namespace winnow
