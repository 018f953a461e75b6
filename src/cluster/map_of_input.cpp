#include "cluster/map_of_input.hpp"

#include "base/per_slot.hpp"
#include "cluster/used_vertices.hpp"
#include "io/spool_records.hpp"
#include "read/for_each_batch.hpp"
#include "write/append.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

namespace winnow {

namespace {

// The vertices of a view, and where they went.
struct Stretch {
  std::uint64_t first, step, count;
};

// What one thread looks up.
struct Lookup {
  std::unique_ptr<VertexFinder> finder;
  UsedVertices::Reader used;
};

}  // namespace

std::unique_ptr<Spool> map_of_input(Job& job, MeshReader& faces, MeshReader& positions,
                                    std::uint64_t vertices, const MakeFinder& make_finder,
                                    std::uint64_t memory) {
  auto map = std::make_unique<Spool>(job, memory);
  const UsedVertices used(job, faces, vertices);
  job.progress.begin("map vertices", vertices, "vertices");
  PerSlot<Lookup> lookups(job.threads, [&] {
    return std::make_unique<Lookup>(Lookup{make_finder(), UsedVertices::Reader(used)});
  });
  std::vector<Destination> batch;
  for_each_position_batch_in_order(
      job, positions,
      [&](const PositionView& view, BatchBytes& bytes) {
        Lookup& lookup = lookups.local();
        append(bytes, Stretch{view.vertex(0), view.vertex(1) - view.vertex(0), view.count});
        for (std::size_t i = 0; i < view.count; ++i) {
          const Point position{view.axis[0][i], view.axis[1][i], view.axis[2][i]};
          append(bytes, lookup.used.has(view.vertex(i)) ? lookup.finder->find(position) : nowhere);
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
        append_records<Destination>(*map, batch);
      });
  positions.release_memory();
  map->finish();
  return map;
}

}  // namespace winnow
