#include "stitch/refine_settings.hpp"

#include "decimate/carried_values.hpp"
#include "decimate/collapsed_into.hpp"
#include "mesh/vertex_index.hpp"
#include "stitch/collapse_log.hpp"
#include "stitch/round_output.hpp"
#include "stitch/tile.hpp"
#include "stitch/unfolded_tile.hpp"

#include <algorithm>

namespace winnow {

std::uint64_t tile_memory(const RefineSettings& settings, std::uint64_t vertices,
                          std::uint64_t faces) {
  const std::uint64_t collapsing = Tile::memory(vertices, faces, settings.state_size()) +
                                   Decimation::memory(settings.decimation, vertices) +
                                   (settings.records() ? vertices * settings.state_size() : 0) +
                                   CarriedValues::memory(vertices, settings.attributes.size()) +
                                   (settings.map ? CollapsedInto::memory(vertices) : 0) +
                                   result_memory(settings, faces);
  return settings.unfolds() ? std::max(collapsing, unfolded_tile_memory(vertices, faces))
                            : collapsing;
}

std::uint64_t result_memory(const RefineSettings& settings, std::uint64_t faces) {
  const std::uint64_t log = faces / 2 * CollapseLog::entry_size;
  const std::size_t attributes = settings.attributes.size() * sizeof(double);
  const std::uint64_t rest = faces / 2 *
                             (sizeof(IndexedVertex) + settings.state_size() + attributes +
                              (settings.map ? sizeof(TileDestination) : 0) + settings.record_bytes);
  return std::max(log, rest);
}

}  // namespace winnow
