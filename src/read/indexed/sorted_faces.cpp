#include "read/indexed/sorted_faces.hpp"

#include "base/memory_shares.hpp"
#include "base/parallel.hpp"
#include "read/for_each_batch.hpp"
#include "read/indexed/buffered_faces.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace winnow {

namespace {

// Files that are open at a time, of the thousand that a process usually may have.
constexpr std::size_t most_parts = 512;

}  // namespace

std::uint64_t SortedFaces::near(std::size_t record_bytes, std::uint64_t memory) {
  return share::reading::near_faces(memory) / record_bytes;
}

// Faces of one part span the part and twice what is near: together what VertexStore looks up in its
// mapping at once. Small parts bring more cells together.
std::optional<SortedFaces::Plan> SortedFaces::plan(std::uint64_t vertices, std::size_t record_bytes,
                                                   std::uint64_t memory) {
  const std::uint64_t part_bytes = share::reading::sorted_part(memory);
  Plan plan;
  plan.near = near(record_bytes, memory);
  if (vertices == 0 || plan.near == 0) return {};
  plan.part_bits = part_bits_for(part_bytes, record_bytes);
  constexpr std::uint64_t usual_part_bytes = std::uint64_t{1} << 20;
  const unsigned usual_bits = part_bits_for(usual_part_bytes, record_bytes);
  while (plan.part_bits > usual_bits && parts_of(vertices, plan.part_bits - 1) < most_parts)
    --plan.part_bits;
  plan.parts = parts_of(vertices, plan.part_bits) + 1;
  if (plan.parts > most_parts) return {};
  plan.buffer_bytes = part_buffer_bytes(memory, plan.parts) / sizeof(Face) * sizeof(Face);
  if (plan.buffer_bytes == 0) return {};
  return plan;
}

std::size_t SortedFaces::part_of(const Face& face) const {
  const auto [low, high] = std::minmax({face.corner[0], face.corner[1], face.corner[2]});
  const std::size_t part = face.corner[0] >> plan_.part_bits;
  return high - low > plan_.near || part >= plan_.parts - 1 ? plan_.parts - 1 : part;
}

void SortedFaces::build(const NextFaces& next, const std::function<void(RawBatch&)>& indices,
                        std::uint64_t count) {
  const ProgressMeter::Inner stage(job_.progress, "sort faces", count, "faces");
  files_ = part_files(job_, plan_.parts);
  PartBuffers buffers(job_, plan_.buffer_bytes, files_);
  struct Item {
    RawBatch batch;
    std::vector<std::uint32_t> ends;  // of each part, in ...
    std::vector<Face> given, sorted;
  };
  pipeline<Item>(
      batches_in_flight(job_.threads), [&](Item& item) { return next(item.batch); },
      [&](Item& item) {
        indices(item.batch);
        job_.progress.advance(item.batch.count);
        item.ends.assign(plan_.parts + 1, 0);
        item.given.clear();
        for (std::size_t i = 0; i < item.batch.count; ++i) {
          const auto number = static_cast<std::uint32_t>(item.batch.first + i);
          item.given.push_back({BufferedFaces::kept(item.batch, i), number});
          ++item.ends[part_of(item.given.back()) + 1];
        }
        std::partial_sum(item.ends.begin(), item.ends.end(), item.ends.begin());
        item.sorted.resize(item.given.size());
        for (const Face& face : item.given) item.sorted[item.ends[part_of(face)]++] = face;
        item.batch = {};
      },
      // Each beginning went on to its part's end.
      [&](const Item& item) { buffers.append(item.sorted, item.ends); });
  buffers.finish();
}

bool SortedFaces::next(std::size_t most, RawBatch& batch) {
  while (part_ < files_.size() && place_ * sizeof(Face) == files_[part_]->size()) {
    ++part_;
    place_ = 0;
  }
  if (part_ == files_.size()) return false;
  batch.count = std::min<std::uint64_t>(most, files_[part_]->size() / sizeof(Face) - place_);
  read_.resize(batch.count);
  files_[part_]->read(place_ * sizeof(Face), std::as_writable_bytes(std::span(read_)));
  for (const Face& face : read_) {
    batch.indices.insert(batch.indices.end(), face.corner.begin(), face.corner.end());
    batch.numbers.push_back(face.number);
  }
  place_ += batch.count;
  BufferedFaces::restore_status(batch);
  return true;
}

}  // namespace winnow
