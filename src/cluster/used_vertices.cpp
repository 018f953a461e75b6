#include "cluster/used_vertices.hpp"

#include "base/memory_shares.hpp"
#include "base/per_slot.hpp"
#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"
#include "read/for_each_batch.hpp"
#include "read/good_faces.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>

namespace winnow {

namespace {

constexpr std::uint64_t least_memory = std::uint64_t{1} << 16;
constexpr unsigned vertices_a_word = 64;

constexpr std::uint64_t bit_of(std::uint64_t vertex) {
  return std::uint64_t{1} << vertex % vertices_a_word;
}

struct NumberedWord {
  std::uint64_t number, bits;

  static bool before(const NumberedWord& a, const NumberedWord& b) { return a.number < b.number; }
  static bool combine(NumberedWord& a, const NumberedWord& b) {
    a.bits |= b.bits;
    return true;
  }
};

// Gathers the bits of vertices that one thread's faces name soon after each other.
class WordGatherer {
 public:
  explicit WordGatherer(SortedList<NumberedWord>& sorted) : sorted_(sorted) {}

  void mark(std::uint64_t vertex) {
    const std::uint64_t number = vertex / vertices_a_word;
    NumberedWord& recent = recent_[number % recent_.size()];
    if (recent.number != number) {
      flush(recent);
      recent.number = number;
    }
    recent.bits |= bit_of(vertex);
  }
  void flush() {
    for (NumberedWord& recent : recent_) flush(recent);
  }

 private:
  void flush(NumberedWord& recent) {
    if (recent.bits != 0) sorted_.add(recent);
    recent.bits = 0;
  }

  SortedList<NumberedWord>& sorted_;
  std::array<NumberedWord, 512> recent_{};
};

Pages room_for_bits(Job& job, std::uint64_t vertices) {
  constexpr std::uint64_t page = 4096;
  const std::uint64_t all = (vertices / vertices_a_word + 1) * sizeof(std::uint64_t);
  const std::uint64_t share = share::left::used(job.budget.left()) / page * page;
  return Pages::allocate(job.budget, std::max(least_memory, std::min(all, share)),
                         "the vertices that faces use");
}

void mark(std::uint64_t& word, std::uint64_t vertex) {
  const std::atomic_ref<std::uint64_t> bits(word);
  if ((bits.load(std::memory_order_relaxed) & bit_of(vertex)) == 0)
    bits.fetch_or(bit_of(vertex), std::memory_order_relaxed);
}

// One word after the other, from word `first` on.
Spool dense(Job& job, MergedCursor<NumberedWord> words, std::uint64_t first) {
  Spool out(job, share::left::map(job.budget.left()));
  Appender<std::uint64_t> append(job, out);
  std::uint64_t next = first;
  for (NumberedWord word{}; words.next(word); ++next) {
    for (; next < word.number; ++next) append.add(0);
    append.add(word.bits);
  }
  append.flush();
  out.finish();
  return out;
}

}  // namespace

UsedVertices::UsedVertices(Job& job, MeshReader& faces, std::uint64_t vertices)
    : bits_(room_for_bits(job, vertices)) {
  const bool all = vertices <= words_in_memory() * vertices_a_word;
  const std::uint64_t least = job.threads * least_memory;
  ThreadedRecords<NumberedWord> sorted(
      job, all ? least : std::max(least, share::left::sorting_used(job.budget.left())));
  PerSlot<WordGatherer> gatherers(job.threads,
                                  [&] { return std::make_unique<WordGatherer>(sorted.local()); });
  job.progress.begin("find used vertices", faces.facts().faces.value_or(0), "faces");
  faces.begin_faces();
  for_each_face_batch(job, faces,
                      [&](const FaceBatch& batch) {
                        const GoodFaces good(batch);
                        for (const NumberedFace& face : good.faces()) {
                          const std::size_t place = face.number - batch.first;
                          for (std::size_t corner = 0; corner < 3; ++corner) {
                            const std::uint64_t vertex = batch.vertex(corner, place);
                            const std::uint64_t word = vertex / vertices_a_word;
                            if (word < words_in_memory()) {
                              mark(bits_.as<std::uint64_t>()[word], vertex);
                            } else {
                              gatherers.local().mark(vertex);
                            }
                          }
                        }
                      },
                      {});
  faces.release_memory();
  for (WordGatherer* gatherer : gatherers.all()) gatherer->flush();
  others_.emplace(dense(job, sorted.merged(), words_in_memory()));
}

UsedVertices::Reader::Reader(const UsedVertices& used) : used_(used) {
  if (used.others_->size() > 0) others_.emplace(*used.others_, sizeof(std::uint64_t));
}

bool UsedVertices::Reader::has(std::uint64_t vertex) {
  const std::uint64_t word = vertex / vertices_a_word;
  const std::uint64_t in_memory = used_.words_in_memory();
  if (word < in_memory) return (used_.bits_.as<std::uint64_t>()[word] & bit_of(vertex)) != 0;
  if (word - in_memory >= record_count<std::uint64_t>(*used_.others_)) return false;
  return (others_->at<std::uint64_t>(word - in_memory) & bit_of(vertex)) != 0;
}

}  // namespace winnow
