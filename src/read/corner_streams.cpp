#include "read/corner_streams.hpp"

#include "base/memory_shares.hpp"
#include "base/pages.hpp"
#include "base/parallel.hpp"
#include "read/for_each_batch.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>
#include <utility>

namespace winnow {

namespace {

// Two files each are open at a time, of the thousand that a process usually may have.
constexpr std::size_t most_streams = 256;
// Lookups in a part of this size find most in a core's caches; so many parts are still written to
// in long stretches.
constexpr std::uint64_t usual_part_bytes = std::uint64_t{8} << 20;
constexpr std::size_t usual_parts = 64;

constexpr std::size_t usual_chunk_corners = std::size_t{1} << 14;

// The usual sizes of a record get loops of their own.
template <std::size_t Bytes>
void copy_records(const std::byte* records, std::span<const std::uint32_t> numbers,
                  std::byte* out) {
  for (const std::uint32_t number : numbers) {
    std::memcpy(out, records + std::size_t{number} * Bytes, Bytes);
    out += Bytes;
  }
}

void copy_records(const std::byte* records, std::size_t bytes,
                  std::span<const std::uint32_t> numbers, std::byte* out) {
  if (bytes == 12) return copy_records<12>(records, numbers, out);
  if (bytes == 24) return copy_records<24>(records, numbers, out);
  for (const std::uint32_t number : numbers) {
    std::memcpy(out, records + number * bytes, bytes);
    out += bytes;
  }
}

}  // namespace

std::optional<CornerStreams::Plan> CornerStreams::plan(std::uint64_t vertices,
                                                       std::size_t record_bytes,
                                                       std::uint64_t memory, unsigned threads) {
  if (vertices == 0 || share::reading::corner_part(memory) < record_bytes) return {};
  Plan plan;
  plan.part_bits = part_bits_for(share::reading::corner_part(memory), record_bytes);
  const unsigned usual_bits = part_bits_for(usual_part_bytes, record_bytes);
  while (plan.part_bits > usual_bits && parts_of(vertices, plan.part_bits - 1) <= usual_parts)
    --plan.part_bits;
  const std::uint64_t parts = parts_of(vertices, plan.part_bits);
  if (parts > most_streams) return {};
  plan.parts = parts;
  plan.buffer_bytes = part_buffer_bytes(memory, parts);
  plan.chunks = std::min<std::size_t>(2 * std::size_t{threads} + 1, 9);
  plan.chunk_corners = std::min<std::uint64_t>(
      usual_chunk_corners, share::reading::corner_chunks(memory) /
                               (plan.chunks * (sizeof(std::uint32_t) + record_bytes)));
  plan.batch_faces =
      share::reading::corner_batches(memory) / (batches_in_flight(threads) * 3 * record_bytes);
  // Less would be no better than a lookup for each.
  constexpr std::size_t least = 64;
  if (plan.buffer_bytes < least || plan.chunk_corners < least || plan.batch_faces < least)
    return {};
  return plan;
}

CornerStreams::CornerStreams(Job& job, const VertexStore& vertices, const Plan& plan)
    : job_(job), vertices_(vertices), plan_(plan), packed_(vertices.layout()) {}

void CornerStreams::build(const NextFaces& next, const CornerNumbers& numbers,
                          std::uint64_t count) {
  sort_by_part(next, numbers, count);
  look_up();
}

void CornerStreams::sort_by_part(const NextFaces& next, const CornerNumbers& numbers,
                                 std::uint64_t count) {
  const ProgressMeter::Inner stage(job_.progress, "sort corners", count, "faces");
  numbers_ = part_files(job_, plan_.parts);
  PartBuffers buffers(job_, plan_.buffer_bytes, numbers_);
  struct Item {
    RawBatch batch;
    std::vector<std::uint32_t> given, sorted, begins;
  };
  pipeline<Item>(
      batches_in_flight(job_.threads), [&](Item& item) { return next(item.batch); },
      [&](Item& item) {
        numbers(item.batch, item.given);
        job_.progress.advance(item.batch.count);
        item.batch = {};  // lets a mapped window go
        for (std::uint32_t& number : item.given) number = existing(number);
        item.begins = begins_of(item.given);
        item.sorted.resize(item.given.size());
        const std::uint32_t inside = (std::uint32_t{1} << plan_.part_bits) - 1;
        for (const std::uint32_t number : item.given)
          item.sorted[item.begins[number >> plan_.part_bits]++] = number & inside;
      },
      // A part's beginning went on to its end.
      [&](const Item& item) { buffers.append(item.sorted, item.begins); });
  buffers.finish();
}

void CornerStreams::look_up() {
  std::uint64_t corners = 0;
  for (const auto& file : numbers_) corners += file->size() / sizeof(std::uint32_t);
  const ProgressMeter::Inner stage(job_.progress, "look up corners", corners, "corners");
  const std::uint64_t part_records =
      std::min(vertices_.size(), std::uint64_t{1} << plan_.part_bits);
  const Pages memory =
      Pages::allocate(job_.budget, part_records * packed_.size(), "looking up corners");
  const Reservation chunks = job_.budget.reserve(
      plan_.chunks * plan_.chunk_corners * (sizeof(std::uint32_t) + packed_.size()),
      "looking up corners");
  for (std::size_t part = 0; part < plan_.parts; ++part) {
    records_.push_back(std::make_unique<ScratchFile>(job_.scratch));
    if (numbers_[part]->size() > 0) {
      load(part, memory.data());
      look_up(part, memory.data());
    }
    numbers_[part].reset();
  }
  numbers_.clear();
}

void CornerStreams::load(std::size_t part, std::byte* into) const {
  const std::uint64_t begin = std::uint64_t{part} << plan_.part_bits;
  const std::uint64_t end =
      std::min(vertices_.size(), begin + (std::uint64_t{1} << plan_.part_bits));
  const std::size_t stride = vertices_.layout().stride;
  const std::uint64_t at_once = std::max<std::uint64_t>(1, scratch_write_bytes / stride);
  std::vector<std::byte> whole(packed_.same() ? 0 : at_once * stride);
  for (std::uint64_t first = begin; first < end; first += at_once) {
    const std::size_t count = std::min(at_once, end - first);
    std::byte* at = into + (first - begin) * packed_.size();
    vertices_.read_records(first, count, packed_.same() ? at : whole.data());
    if (!packed_.same()) packed_.pack(whole.data(), count, at);
    job_.progress.check_cancelled();
  }
}

void CornerStreams::look_up(std::size_t part, const std::byte* vertices) {
  const ScratchFile& numbers = *numbers_[part];
  ScratchFile& records = *records_[part];
  struct Chunk {
    std::vector<std::uint32_t> numbers;
    std::vector<std::byte> records;
  };
  const std::uint64_t total = numbers.size() / sizeof(std::uint32_t);
  std::uint64_t done = 0;
  pipeline<Chunk>(
      plan_.chunks,
      [&](Chunk& chunk) {
        chunk.numbers.resize(std::min<std::uint64_t>(plan_.chunk_corners, total - done));
        numbers.read(done * sizeof(std::uint32_t),
                     std::as_writable_bytes(std::span(chunk.numbers)));
        done += chunk.numbers.size();
        return !chunk.numbers.empty();
      },
      [&](Chunk& chunk) {
        chunk.records.resize(chunk.numbers.size() * packed_.size());
        copy_records(vertices, packed_.size(), chunk.numbers, chunk.records.data());
        job_.progress.advance(chunk.numbers.size());
      },
      [&](const Chunk& chunk) { records.append(chunk.records); });
}

void CornerStreams::begin() {
  next_.assign(plan_.parts, 0);
  if (reservation_) return;
  reservation_ =
      job_.budget.reserve(batches_in_flight(job_.threads) * plan_.batch_faces * 3 * packed_.size(),
                          "corners on their way");
}

void CornerStreams::add_records(RawBatch& batch) {
  batch.records_begin = begins_of(batch.indices);
  batch.records.resize(batch.indices.size() * packed_.size());
  for (std::size_t part = 0; part < plan_.parts; ++part) {
    const std::uint64_t begin = batch.records_begin[part];
    const std::uint64_t count = batch.records_begin[part + 1] - begin;
    records_[part]->read(
        next_[part] * packed_.size(),
        std::span(batch.records).subspan(begin * packed_.size(), count * packed_.size()));
    next_[part] += count;
  }
}

void CornerStreams::gather(const RawBatch& batch, Cursors& cursors,
                           const std::array<const std::uint32_t*, 3>& index, std::size_t count,
                           FaceBatch& out) const {
  std::array<std::array<std::uint32_t, FaceBatch::capacity>, 3> place;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner)
      place[corner][i] = cursors[index[corner][i] >> plan_.part_bits]++;
  }
  vertices_.gather_records(batch.records.data(), packed_.layout(),
                           {place[0].data(), place[1].data(), place[2].data()}, count, out);
}

std::vector<std::uint32_t> CornerStreams::begins_of(std::span<const std::uint32_t> numbers) const {
  std::vector<std::uint32_t> begins(plan_.parts + 1);
  for (const std::uint32_t number : numbers) ++begins[(existing(number) >> plan_.part_bits) + 1];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  return begins;
}

}  // namespace winnow
