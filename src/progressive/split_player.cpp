#include "progressive/split_player.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace winnow {

namespace {

// What remembering a split takes, about.
constexpr std::uint64_t done_bytes = 160;
constexpr std::size_t read_at_once = std::size_t{1} << 20;

}  // namespace

SplitPlayer::SplitPlayer(Job& job, std::unique_ptr<ByteSource> source, bool back)
    : job_(job),
      source_(std::move(source)),
      back_(back),
      header_(read_header(job, *source_)),
      words_(header_.form, header_.attributes),
      mesh_(std::in_place, words_.width()) {
  read_base();
}

void SplitPlayer::read_base() {
  const ProgressiveHeader::Counts base = header_.base();
  make_room(base.vertices, base.faces);
  while (chunk_ < header_.base_chunks) {
    if (!open_chunk())
      throw Error(ErrorKind::bad_input,
                  "'" + source_->name() + "' is cut short: its coarsest mesh is not whole");
    while (decoder_->left() > 0) {
      decoder_->next(*mesh_, decoded_);
      apply(decoded_, decoder_->left() == 0);
    }
  }
  decoder_.reset();
  cut_short_ = false;
}

void SplitPlayer::expect(std::uint64_t faces) {
  const ProgressiveHeader::Counts counts = header_.counts(header_.chunks_for(faces));
  make_room(counts.vertices, counts.faces);
}

void SplitPlayer::expect(std::uint64_t faces, ScratchMemory& scratch) {
  const ProgressiveHeader::Counts counts = header_.counts(header_.chunks_for(faces));
  if (counts.vertices <= room_vertices_ && counts.faces <= room_faces_) return;
  SplitMesh moved(*mesh_, &scratch, counts.vertices, counts.faces);
  mesh_.emplace(std::move(moved));
  mesh_memory_ = {};
  scratch_ = &scratch;
  room_vertices_ = counts.vertices;
  room_faces_ = counts.faces;
}

std::uint64_t SplitPlayer::memory_for(std::uint64_t vertices, std::uint64_t faces) const {
  const std::uint64_t steps = back_ ? vertices * done_bytes : 0;
  return SplitMesh::memory(vertices, faces, words_.width()) + steps;
}

void SplitPlayer::make_room(std::uint64_t vertices, std::uint64_t faces) {
  if (vertices <= room_vertices_ && faces <= room_faces_) return;
  take_room(vertices, faces, job_.budget.reserve(memory_for(vertices, faces), "so many faces"));
}

void SplitPlayer::take_room(std::uint64_t vertices, std::uint64_t faces, Reservation memory) {
  room_vertices_ = vertices;
  room_faces_ = faces;
  mesh_->reserve(vertices, faces);
  mesh_memory_ = std::move(memory);
}

// For the chunk that is open; where nothing was expected, for some more.
void SplitPlayer::grow() {
  if (end_.vertices <= room_vertices_ && end_.faces <= room_faces_) return;
  const std::uint64_t vertices = end_.vertices + end_.vertices / 2;
  const std::uint64_t faces = end_.faces + end_.faces / 2;
  Reservation more = job_.budget.try_reserve(memory_for(vertices, faces));
  if (more) return take_room(vertices, faces, std::move(more));
  make_room(end_.vertices, end_.faces);
}

void SplitPlayer::refuse_chunk(std::size_t chunk, const std::string& why) const {
  throw Error(ErrorKind::bad_input,
              "'" + source_->name() + "' is damaged: chunk " + std::to_string(chunk) + " " + why);
}

std::vector<std::byte> SplitPlayer::chunk_bytes(const ChunkEntry& entry) {
  std::vector<std::byte> bytes;
  bytes.reserve(entry.bytes);
  while (bytes.size() < entry.bytes) {
    job_.progress.check_cancelled();
    const Block block =
        source_->take(std::min<std::size_t>(read_at_once, entry.bytes - bytes.size()));
    if (block.bytes.empty()) break;
    bytes.insert(bytes.end(), block.bytes.begin(), block.bytes.end());
    block.check_intact(source_->name());
  }
  return bytes;
}

bool SplitPlayer::open_chunk() {
  if (chunk_ == header_.chunks.size() || cut_short_) return false;
  const ChunkEntry& entry = header_.chunks[chunk_];
  if (entry.bytes > entry.raw_bytes + entry.raw_bytes / 16 + 1024)
    refuse_chunk(chunk_, "is longer packed than not");
  decoder_.reset();
  chunk_memory_ = {};
  chunk_memory_ = job_.budget.reserve(entry.bytes + 4 * std::uint64_t{entry.raw_bytes}, "a chunk");
  const std::vector<std::byte> bytes = chunk_bytes(entry);
  if (bytes.size() < entry.bytes) {
    cut_short_ = true;
    return false;
  }
  if (checksum_of(bytes) != entry.checksum) refuse_chunk(chunk_, "is not what was written");
  end_.vertices += entry.vertices;
  end_.faces += entry.faces;
  grow();
  try {
    decoder_.emplace(bytes, entry.raw_bytes, entry.splits, words_.width());
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    refuse_chunk(chunk_, "cannot be unpacked");
  }
  ++chunk_;
  chunk_begins_ = true;
  job_.progress.advance(entry.faces);
  return true;
}

const Split* SplitPlayer::next() {
  if (!undone_.empty()) return &undone_.back();
  if (has_decoded_) return &decoded_;
  while (!decoder_ || decoder_->left() == 0) {
    if (!open_chunk()) return nullptr;
  }
  try {
    decoder_->next(*mesh_, decoded_);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    refuse_chunk(chunk_ - 1, "has a split that cannot be");
  }
  has_decoded_ = true;
  return &decoded_;
}

// Where it throws the mesh is as it was.
void SplitPlayer::apply(const Split& split, bool last_of_chunk) {
  const std::uint64_t vertices = mesh_->vertices() + std::uint64_t{split.new_vertices};
  const std::uint64_t faces = mesh_->faces() + std::uint64_t{split.restored.size()};
  if (vertices > end_.vertices || faces > end_.faces ||
      (last_of_chunk && (vertices != end_.vertices || faces != end_.faces)))
    refuse_chunk(chunk_ - 1, "brings back other faces than it should");
  if (!mesh_->apply(split)) refuse_chunk(chunk_ - 1, "has a split that cannot be");
}

bool SplitPlayer::forward() {
  const Split* split = next();
  if (split == nullptr) return false;
  const bool again = !undone_.empty();
  SplitMesh::Undo undo;
  if (back_) undo = mesh_->undo_of(*split);
  apply(*split, !again && decoder_->left() == 0);
  const bool begins = !again && std::exchange(chunk_begins_, false);
  if (back_) done_.push_back({std::move(undo), begins ? chunk_ - 1 : no_chunk});
  if (again) {
    undone_.pop_back();
  } else {
    has_decoded_ = false;
  }
  return true;
}

bool SplitPlayer::backward() {
  if (done_.empty()) return false;
  const Done done = std::move(done_.back());
  done_.pop_back();
  mesh_->take_back(done.undo, undone_.emplace_back());
  if (done.chunk != no_chunk) rewind_to(done.chunk);
  return true;
}

void SplitPlayer::rewind_to(std::size_t chunk) {
  undone_.clear();
  has_decoded_ = false;
  decoder_.reset();
  chunk_ = chunk;
  end_ = header_.counts(chunk);
  source_->seek(end_.bytes);
  cut_short_ = false;
}

void SplitPlayer::go_to(std::uint64_t faces) {
  for (std::uint64_t steps = 0; mesh_->faces() > faces && backward(); ++steps) {
    if (steps % 4096 == 0) job_.progress.check_cancelled();
  }
  for (std::uint64_t steps = 0;; ++steps) {
    const Split* split = next();
    if (split == nullptr || mesh_->faces() + split->restored.size() > faces) return;
    forward();
    if (steps % 4096 == 0) job_.progress.check_cancelled();
    if (scratch_ != nullptr && steps % 64 == 0) scratch_->give_back();
  }
}

}  // namespace winnow
