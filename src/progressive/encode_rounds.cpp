#include "progressive/encode_rounds.hpp"

#include "base/budget.hpp"
#include "base/parallel.hpp"
#include "io/inverse_numbers.hpp"
#include "io/recent_blocks.hpp"
#include "io/spool_records.hpp"
#include "progressive/recorded_collapse.hpp"
#include "progressive/shares.hpp"
#include "progressive/split_codec.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace winnow {

namespace {

// Vertices or faces of the base that are told of at once, and as often in one chunk.
constexpr std::uint64_t base_step = 1024;
constexpr std::uint64_t base_chunk = 32 * base_step;

// In the order of the file: those of the base, then those that each part brings back.
template <typename Each>
void for_each_vertex(Job& job, const RecordedRounds& rounds, const StoredMesh& base, bool numbered,
                     const Each& each) {
  SpoolCursor<IndexedVertex> vertices(job, base.vertices->records());
  std::uint32_t number = 0;
  for (IndexedVertex vertex; vertices.next(vertex); ++number)
    each(numbered ? vertex.unused : number);
  for_each_part(rounds, [&](const RecordedRound& round, const RecordedPart& part) {
    const std::vector<std::uint32_t> gone =
        read_records<std::uint32_t>(round.gone(), part.first_gone, part.vertices);
    for (auto v = gone.rbegin(); v != gone.rend(); ++v) each(*v);
    job.progress.check_cancelled();
  });
}

// Of all vertices of the whole mesh. (A vertex that is not recorded once is an error of ours.)
Spool file_numbers(Job& job, const RecordedRounds& rounds, const StoredMesh& base, bool numbered,
                   std::uint64_t vertices, std::uint64_t memory) {
  Spool numbers(job, share::progressive::numbers(memory));
  InverseNumbers in_file(job, vertices, share::progressive::sorting(memory));
  for_each_vertex(job, rounds, base, numbered, [&](std::uint32_t vertex) { in_file.add(vertex); });
  in_file.append_to(numbers);
  numbers.finish();
  return numbers;
}

struct Chunk {
  std::size_t part = 0;
  ChunkEntry entry;
  std::vector<std::byte> bytes;
};

void finish_chunk(SplitEncoder& encoder, Chunk& chunk) {
  chunk.bytes = encoder.finish(chunk.entry.raw_bytes);
  chunk.entry.bytes = static_cast<std::uint32_t>(chunk.bytes.size());
  chunk.entry.checksum = checksum_of(chunk.bytes);
}

class RoundEncoder {
 public:
  RoundEncoder(Job& job, const RecordedRounds& rounds, const VertexWords& words, EncodedRounds& out)
      : job_(job), words_(words), out_(out) {
    for_each_part(rounds, [&](const RecordedRound& round, const RecordedPart& part) {
      parts_.push_back({&round, &part, part.error});
    });
    for (std::size_t i = parts_.size(); i-- > 1;)
      parts_[i - 1].error = std::max(parts_[i - 1].error, parts_[i].error);
  }

  void add_base(const StoredMesh& base) {
    const std::uint64_t vertices = base.vertices->size();
    in_chunks(
        vertices,
        [&](std::uint64_t first, std::uint64_t count, Split& split, ChunkEntry& entry) {
          add_vertices(base, first, count, split);
          entry.vertices += split.new_vertices;
        },
        0);
    in_chunks(
        base.face_count,
        [&](std::uint64_t first, std::uint64_t count, Split& split, ChunkEntry& entry) {
          split.restored = base.read_faces(first, count);
          entry.faces += static_cast<std::uint32_t>(count);
        },
        static_cast<std::uint32_t>(vertices));
    out_.base_chunks = static_cast<std::uint32_t>(out_.chunks.size());
  }

  void add_parts(const Spool& numbers) {
    std::uint64_t largest = mebibyte;
    for (const Part& part : parts_)
      largest = std::max(largest, 2 * part.part->words * sizeof(std::uint32_t));
    const std::uint64_t at_once =
        std::clamp<std::uint64_t>(job_.budget.left() / largest, 1, job_.threads);
    const Reservation reserved = job_.budget.reserve(at_once * largest, "encoding");
    std::size_t next = 0;
    pipeline<Chunk>(
        at_once,
        [&](Chunk& chunk) {
          chunk = {};
          if (next == parts_.size()) return false;
          chunk.part = next++;
          return true;
        },
        [&](Chunk& chunk) { encode(parts_[chunk.part], numbers, chunk); },
        [&](const Chunk& chunk) { append(chunk); });
  }

 private:
  struct Part {
    const RecordedRound* round;
    const RecordedPart* part;
    double error;  // of the mesh without it and all behind it
  };

  template <typename Add>
  void in_chunks(std::uint64_t count, const Add& add, std::uint32_t first_new) {
    SplitEncoder encoder(words_.width());
    for (std::uint64_t begin = 0; begin < count; begin += base_chunk) {
      Chunk chunk;
      const std::uint64_t end = std::min(count, begin + base_chunk);
      for (std::uint64_t at = begin; at < end; at += base_step) {
        RingedSplit ringed;
        ringed.first_new = first_new;
        add(at, std::min(base_step, end - at), ringed.split, chunk.entry);
        encoder.add(ringed);
        ++chunk.entry.splits;
      }
      chunk.entry.error = parts_.empty() ? 0 : parts_.front().error;
      finish_chunk(encoder, chunk);
      append(chunk);
    }
  }

  void add_vertices(const StoredMesh& base, std::uint64_t first, std::uint64_t count,
                    Split& split) const {
    const std::size_t attributes = base.layout.attributes;
    std::vector<double> means;
    if (attributes > 0)
      means = read_records<double>(*base.attributes, first * attributes, count * attributes);
    std::size_t at = 0;
    for (const IndexedVertex& vertex :
         read_records<IndexedVertex>(base.vertices->records(), first, count)) {
      words_.put(vertex.position, std::span(means).subspan(at, attributes), split.words);
      at += attributes;
    }
    split.new_vertices = static_cast<std::uint32_t>(count);
  }

  void encode(const Part& coded, const Spool& numbers, Chunk& chunk) const {
    const RecordedPart& part = *coded.part;
    const Words words =
        read_records<std::uint32_t>(coded.round->words(), part.first_word, part.words);
    std::vector<std::span<const std::uint32_t>> records;
    RecordedCollapse collapse;
    for (std::span<const std::uint32_t> rest = words; !rest.empty();) {
      records.push_back(rest);
      skip_packed(rest, words_.width());
    }
    RecentBlocks recent(numbers, sizeof(std::uint32_t));
    SplitEncoder encoder(words_.width());
    for (auto record = records.rbegin(); record != records.rend(); ++record) {
      unpack(*record, words_.width(), collapse);
      collapse.for_each_vertex([&](std::uint32_t& v) { v = recent.at<std::uint32_t>(v); });
      collapse.ringed.first_new = collapse.gone.front();
      encoder.add(collapse.ringed);
      if (chunk.entry.splits++ % 1024 == 0) job_.progress.check_cancelled();
    }
    chunk.entry.vertices = part.vertices;
    chunk.entry.faces = part.faces;
    chunk.entry.error = coded.error;
    finish_chunk(encoder, chunk);
  }

  void append(const Chunk& chunk) {
    out_.bytes.append(chunk.bytes);
    out_.chunks.push_back(chunk.entry);
    job_.progress.advance(chunk.entry.faces);
  }

  Job& job_;
  const VertexWords& words_;
  EncodedRounds& out_;
  std::vector<Part> parts_;  // in the order of the file
};

}  // namespace

EncodedRounds encode_rounds(Job& job, const RecordedRounds& rounds, const StoredMesh& base,
                            bool numbered, std::uint64_t vertices, const VertexWords& words,
                            std::uint64_t memory) {
  EncodedRounds out{Spool(job, share::progressive::packed(memory)), {}, 0};
  const Spool numbers = file_numbers(job, rounds, base, numbered, vertices, memory);
  std::uint64_t faces = base.face_count;
  for_each_part(rounds,
                [&](const RecordedRound&, const RecordedPart& part) { faces += part.faces; });
  job.progress.begin("encode", faces, "faces");
  RoundEncoder encoder(job, rounds, words, out);
  encoder.add_base(base);
  encoder.add_parts(numbers);
  out.bytes.finish();
  return out;
}

}  // namespace winnow
