#include "sequence/original_frames.hpp"

#include "io/spool_records.hpp"

#include <algorithm>

namespace winnow {

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

}  // namespace winnow
