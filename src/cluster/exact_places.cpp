#include "cluster/exact_places.hpp"

#include "base/cell_state.hpp"
#include "base/per_slot.hpp"
#include "cluster/weld_lattice.hpp"
#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace winnow {

bool place_exactly(Job& job, const NearFaces& near, const SplitCells& names, bool single,
                   std::uint64_t memory, std::uint64_t vertices, StoredMesh& mesh) {
  ThreadedRecords<KeyedPosition> positions(job, memory);
  PerSlot<RecentPositions> recent(job.threads, [] { return std::make_unique<RecentPositions>(); });
  near.for_each_batch([&](const FaceBatch& faces) {
    for (std::size_t i = 0; i < faces.count; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        Point at = without_minus_zero(faces.corner(c, i));
        if (!recent.local().add(at)) continue;
        const std::optional<CellKey> name = names.finest_part(at);
        if (!name) continue;
        if (single) {
          for (double& coordinate : at) coordinate = double{static_cast<float>(coordinate)};
        }
        positions.local().add({*name, at});
      }
    }
  });
  MergedCursor<KeyedPosition> all = positions.merged();
  KeyedPosition next{};
  bool more = all.next(next);
  VertexIndex placed(job, vertices);
  std::unique_ptr<Spool> states;
  if (mesh.state != nullptr) states = std::make_unique<Spool>(job, vertices);
  Appender<IndexedVertex, VertexIndex> append(job, placed);
  SpoolCursor<IndexedVertex> cursor(job, mesh.vertices->records());
  std::optional<SpoolCursor<CellState>> next_state;
  if (states != nullptr) next_state.emplace(job, *mesh.state);
  CellState state;
  for (IndexedVertex vertex; cursor.next(vertex);) {
    if (next_state) next_state->next(state);
    for (; more && next.key < vertex.key; more = all.next(next)) {
    }
    if (more && next.key == vertex.key) {
      // Nothing else is there.
      state = {state.planes.from(next.position - vertex.position), {}, {}};
      vertex.position = next.position;
      more = all.next(next);
      // Rounding must not carry it to where another may be.
      if ((more && next.key == vertex.key) || names.finest_part(vertex.position) != vertex.key)
        return false;
    }
    append.add(vertex);
    if (states != nullptr) append_records<CellState>(*states, std::span(&state, 1));
  }
  append.flush();
  placed.finish();
  mesh.vertices = std::make_unique<VertexIndex>(std::move(placed));
  if (states == nullptr) return true;
  states->finish();
  mesh.state = std::move(states);
  return true;
}

}  // namespace winnow
