#include "sequence/original_frames.hpp"

#include "io/spool_records.hpp"

#include <algorithm>
#include <span>

namespace winnow {

namespace {

constexpr const char* places_file = "stage-input.frames";
constexpr const char* used_file = "stage-input.used";  // a bit for each vertex of a frame
constexpr const char* vertex_count = "frames.vertices";

}  // namespace

std::unique_ptr<VertexIndex> OriginalFrames::vertices(Job& job, std::size_t frame,
                                                      const VertexIndex& first,
                                                      std::uint64_t memory) const {
  auto out = std::make_unique<VertexIndex>(job, memory);
  SpoolCursor<IndexedVertex> keys(job, first.records());
  Appender<IndexedVertex, VertexIndex> append(job, *out);
  const std::size_t count = in_mesh.size();
  IndexedVertex vertex;
  for (std::size_t at = 0; at < count; at += chunk_records) {
    const std::size_t part = std::min(chunk_records, count - at);
    const std::vector<Point> positions = read_records<Point>(*places, frame * count + at, part);
    for (std::size_t i = 0; i < part; ++i) {
      if (!in_mesh[at + i]) continue;
      keys.next(vertex);
      vertex.position = positions[i];
      append.add(vertex);
    }
  }
  append.flush();
  out->finish();
  return out;
}

void OriginalFrames::save(Job& job, CheckpointDirectory& checkpoint) const {
  Spool used(job, job.budget.left());
  std::vector<std::byte> bits;
  for (std::size_t v = 0; v < in_mesh.size(); ++v) {
    if (v % 8 == 0) bits.push_back({});
    bits.back() |= std::byte{in_mesh[v]} << v % 8;
  }
  used.append(bits);
  used.finish();
  checkpoint.save(places_file, *places);
  checkpoint.save(used_file, used);
  checkpoint.manifest().set(vertex_count, std::uint64_t{in_mesh.size()});
}

OriginalFrames OriginalFrames::load(Job& job, const CheckpointDirectory& checkpoint,
                                    std::uint64_t memory) {
  OriginalFrames frames;
  frames.places = std::make_unique<Spool>(checkpoint.load(places_file, memory));
  const Spool used = checkpoint.load(used_file, job.budget.left());
  const std::uint64_t vertices = checkpoint.manifest().number(vertex_count);
  if (used.size() != (vertices + 7) / 8)
    damaged_checkpoint(checkpoint.file(used_file), "its size does not fit");
  frames.in_mesh.reserve(vertices);
  used.for_each_part(1, [&](std::span<const std::byte> part) {
    for (const std::byte bits : part) {
      for (unsigned bit = 0; bit < 8 && frames.in_mesh.size() < vertices; ++bit)
        frames.in_mesh.push_back((bits >> bit & std::byte{1}) != std::byte{0});
    }
  });
  return frames;
}

}  // namespace winnow
