#include "cluster/map_of_input.hpp"

#include "base/memory_shares.hpp"
#include "base/pages.hpp"
#include "base/per_slot.hpp"
#include "io/spool_records.hpp"
#include "read/for_each_batch.hpp"
#include "read/good_faces.hpp"
#include "write/append.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <vector>

namespace winnow {

namespace {

// Which vertices of a range good faces have; marked from all threads.
class UsedVertices {
 public:
  // As many of `vertices` as there is room for.
  UsedVertices(Job& job, std::uint64_t vertices) {
    for (std::uint64_t bytes = rounded_up(vertices);;
         bytes = std::max(least_bytes, bytes / 16 * 8)) {
      if (bytes == least_bytes) {
        pages_ = Pages::allocate(job.budget, bytes, "the vertices that faces use");
        return;
      }
      if (bytes > share::left::used(job.budget.left())) continue;
      pages_ = Pages::try_allocate(job.budget, bytes);
      if (pages_) return;
    }
  }

  // Begins anew, with the range from `first` on.
  void begin(std::uint64_t first) {
    if (first > 0) pages_.clear();
    first_ = first;
  }
  [[nodiscard]] std::uint64_t first() const { return first_; }
  [[nodiscard]] std::uint64_t end() const { return first_ + 8 * pages_.size(); }

  void mark(std::uint64_t vertex) {
    if (!in_range(vertex)) return;
    const std::atomic_ref<std::uint64_t> bits(word(vertex));
    const std::uint64_t mine = bit(vertex);
    if ((bits.load(std::memory_order_relaxed) & mine) == 0)
      bits.fetch_or(mine, std::memory_order_relaxed);
  }
  // When all are marked.
  [[nodiscard]] bool has(std::uint64_t vertex) const {
    return in_range(vertex) && (word(vertex) & bit(vertex)) != 0;
  }

 private:
  static constexpr std::uint64_t least_bytes = std::uint64_t{1} << 16;

  static std::uint64_t rounded_up(std::uint64_t vertices) {
    return std::max(least_bytes, (vertices / 64 + 1) * sizeof(std::uint64_t));
  }
  [[nodiscard]] bool in_range(std::uint64_t vertex) const {
    return vertex >= first_ && vertex < end();
  }
  [[nodiscard]] std::uint64_t& word(std::uint64_t vertex) const {
    return pages_.as<std::uint64_t>()[(vertex - first_) / 64];
  }
  [[nodiscard]] std::uint64_t bit(std::uint64_t vertex) const {
    return std::uint64_t{1} << (vertex - first_) % 64;
  }

  Pages pages_;
  std::uint64_t first_ = 0;
};

void mark_used(Job& job, MeshReader& reader, UsedVertices& used) {
  reader.begin_faces();
  for_each_face_batch(job, reader,
                      [&](const FaceBatch& batch) {
                        const GoodFaces good(batch);
                        for (const NumberedFace& face : good.faces()) {
                          const std::size_t place = face.number - batch.first;
                          for (std::size_t corner = 0; corner < 3; ++corner)
                            used.mark(batch.vertex(corner, place));
                        }
                      },
                      {});
  reader.release_memory();
}

// The vertices of a view, and where they went.
struct Stretch {
  std::uint64_t first, step, count;
};

// Appends those of the range in the order of their numbers. Returns how many there are in all.
std::uint64_t find_all(Job& job, MeshReader& reader, const UsedVertices& used,
                       const MakeFinder& make_finder, Spool& out) {
  std::uint64_t all = 0;
  PerSlot<VertexFinder> finders(job.threads, make_finder);
  std::vector<Destination> batch;
  for_each_position_batch_in_order(
      job, reader,
      [&](const PositionView& view, BatchBytes& bytes) {
        VertexFinder& finder = finders.local();
        append(bytes, Stretch{view.vertex(0), view.vertex(1) - view.vertex(0), view.count});
        for (std::size_t i = 0; i < view.count; ++i) {
          const std::uint64_t vertex = view.vertex(i);
          const Point position{view.axis[0][i], view.axis[1][i], view.axis[2][i]};
          append(bytes, used.has(vertex) ? finder.find(position) : nowhere);
        }
      },
      [&](std::span<const std::byte> bytes) {
        // A batch has all vertices from its lowest to its highest.
        batch.clear();
        std::uint64_t lowest = 0;
        Stretch stretch{};
        for (std::size_t at = 0; at < bytes.size(); at += stretch.count * sizeof(Destination)) {
          std::memcpy(&stretch, bytes.data() + at, sizeof stretch);
          at += sizeof stretch;
          if (stretch.count == 0) continue;
          if (batch.empty()) lowest = stretch.first;
          const std::uint64_t last = stretch.first - lowest + stretch.step * (stretch.count - 1);
          batch.resize(std::max<std::size_t>(batch.size(), last + 1), nowhere);
          for (std::uint64_t i = 0; i < stretch.count; ++i) {
            std::memcpy(&batch[stretch.first - lowest + stretch.step * i],
                        bytes.data() + at + i * sizeof(Destination), sizeof(Destination));
          }
        }
        all = std::max(all, lowest + batch.size());
        const std::uint64_t from = std::max(used.first(), lowest);
        const std::uint64_t to = std::min(used.end(), lowest + batch.size());
        if (from < to)
          append_records<Destination>(out, std::span(batch).subspan(from - lowest, to - from));
      });
  reader.release_memory();
  return all;
}

}  // namespace

std::unique_ptr<Spool> map_of_input(Job& job, MeshReader& faces, MeshReader& positions,
                                    std::uint64_t vertices, const MakeFinder& make_finder,
                                    std::uint64_t memory) {
  auto map = std::make_unique<Spool>(job, memory);
  UsedVertices used(job, vertices);
  std::uint64_t all = 0;
  for (std::uint64_t first = 0; first == 0 || first < all; first = used.end()) {
    used.begin(first);
    job.progress.begin("find used vertices", faces.facts().faces.value_or(0), "faces");
    mark_used(job, faces, used);
    job.progress.begin("map vertices", vertices, "vertices");
    all = find_all(job, positions, used, make_finder, *map);
  }
  map->finish();
  return map;
}

}  // namespace winnow
