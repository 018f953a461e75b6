#include "mesh/vertex_index.hpp"

#include "base/hash.hpp"
#include "base/search.hpp"
#include "io/spool_records.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace winnow {

VertexIndex::VertexIndex(Job& job, std::uint64_t memory) : job_(job), records_(job, memory) {}

VertexIndex::VertexIndex(Job& job, Spool records)
    : job_(job), records_(std::move(records)), size_(record_count<IndexedVertex>(records_)) {
  for (std::uint64_t v = 0; v < size_; v += block_vertices)
    first_keys_.push_back(read_record<IndexedVertex>(records_, v).key);
  finish();
}

void VertexIndex::append(std::span<const IndexedVertex> vertices) {
  for (const IndexedVertex& vertex : vertices) {
    if (size_ % block_vertices == 0) first_keys_.push_back(vertex.key);
    ++size_;
  }
  records_.append(std::as_bytes(vertices));
}

void VertexIndex::finish() {
  records_.finish();
  if (first_keys_.empty()) return;
  // About one block a range, if the keys were spread evenly; a search goes on from there.
  const CellKey last = first_keys_.back();
  const auto bits = static_cast<unsigned>(std::bit_width(last));
  const auto wanted = static_cast<unsigned>(std::bit_width(first_keys_.size())) + 1;
  range_shift_ = bits > wanted ? bits - wanted : 0;
  const std::size_t ranges = (last >> range_shift_) + 2;
  reservation_ =
      job_.budget.reserve(ranges * sizeof(std::uint32_t) + first_keys_.capacity() * sizeof(CellKey),
                          "the vertex index");
  range_start_.assign(ranges, 0);
  for (const CellKey key : first_keys_) ++range_start_[(key >> range_shift_) + 1];
  for (std::size_t i = 1; i < ranges; ++i) range_start_[i] += range_start_[i - 1];
}

VertexIndex::Reader::Reader(const VertexIndex& index)
    : index_(index),
      recent_(std::size_t{1} << recent_bits),
      blocks_(index.records_, sizeof(IndexedVertex)) {
  for (Found& found : recent_) found.vertex.key = UINT64_MAX;  // no cell has this key
}

std::span<const IndexedVertex> VertexIndex::Reader::block(std::uint64_t number) {
  const std::span<const std::byte> bytes = blocks_.block(number);
  return {reinterpret_cast<const IndexedVertex*>(bytes.data()),
          bytes.size() / sizeof(IndexedVertex)};
}

const VertexIndex::Reader::Found& VertexIndex::Reader::find(CellKey key) {
  Found& recent = recent_[quick_hash(key) >> (64 - recent_bits)];
  if (recent.vertex.key != key) recent = search(key);
  return recent;
}

std::uint64_t VertexIndex::Reader::lower_bound(CellKey key) {
  if (index_.first_keys_.empty()) return 0;
  // Keys behind the last block's first are above every range.
  const std::size_t range =
      std::min<std::size_t>(key >> index_.range_shift_, index_.range_start_.size() - 2);
  const auto begin = index_.first_keys_.begin();
  // The first block whose first key is not below `key`: the one before may hold keys as high.
  const auto block_after = std::lower_bound(begin + index_.range_start_[range],
                                            begin + index_.range_start_[range + 1], key);
  if (block_after == begin) return 0;
  const auto number = static_cast<std::uint64_t>(block_after - begin) - 1;
  const std::span<const IndexedVertex> vertices = block(number);
  const auto found =
      std::lower_bound(vertices.begin(), vertices.end(), key,
                       [](const IndexedVertex& vertex, CellKey k) { return vertex.key < k; });
  return number * block_vertices + static_cast<std::uint64_t>(found - vertices.begin());
}

std::uint64_t VertexIndex::Reader::find(CellKey key, const Point& position) {
  // Where one vertex lies far off, all others may have one key.
  const std::uint64_t mixed = key + std::bit_cast<std::uint64_t>(position[0]) +
                              3 * std::bit_cast<std::uint64_t>(position[1]) +
                              5 * std::bit_cast<std::uint64_t>(position[2]);
  Found& recent = recent_[quick_hash(mixed) >> (64 - recent_bits)];
  const auto is_it = [&] { return recent.vertex.key == key && recent.vertex.position == position; };
  if (is_it()) return recent.number;
  std::uint64_t number = lower_bound(key);
  if (number == index_.size()) return absent;
  recent = {number, at(number)};
  if (is_it()) return number;
  // Mostly it was the first.
  const std::uint64_t end = lower_bound(key + 1);
  number =
      first_not_before(number, end, [&](std::uint64_t n) { return at(n).position < position; });
  if (number == end) return absent;
  recent = {number, at(number)};
  return is_it() ? number : absent;
}

std::uint64_t VertexIndex::Reader::number_of(CellKey key) {
  Found& recent = recent_[quick_hash(key) >> (64 - recent_bits)];
  if (recent.vertex.key == key) return recent.number;
  const std::uint64_t number = lower_bound(key);
  if (number == index_.size()) return absent;
  const IndexedVertex vertex = at(number);
  if (vertex.key != key) return absent;
  recent = {number, vertex};
  return number;
}

VertexIndex::Reader::Found VertexIndex::Reader::search(CellKey key) {
  // The block is the last whose first key is not above `key`. Keys behind the last block's first
  // are above every range.
  const std::size_t range =
      std::min<std::size_t>(key >> index_.range_shift_, index_.range_start_.size() - 2);
  const auto begin = index_.first_keys_.begin();
  const auto block_after = std::upper_bound(begin + index_.range_start_[range],
                                            begin + index_.range_start_[range + 1], key);
  const auto number = static_cast<std::uint64_t>(block_after - begin) - 1;
  const std::span<const IndexedVertex> vertices = block(number);
  const auto found =
      std::lower_bound(vertices.begin(), vertices.end(), key,
                       [](const IndexedVertex& vertex, CellKey k) { return vertex.key < k; });
  return {number * block_vertices + static_cast<std::uint64_t>(found - vertices.begin()), *found};
}

}  // namespace winnow
