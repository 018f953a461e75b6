#include "stitch/apply_collapses.hpp"

#include "base/memory_shares.hpp"
#include "decimate/collapsed_into.hpp"
#include "mesh/vertex_map.hpp"
#include "stitch/round_output.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

namespace {

// Of a mesh of one tile so many times the wanted faces, and this part of all, are left to be chosen
// in the order of costs.
constexpr double sweeps_beside_wanted = 1.3;
constexpr double sweeps_beside_faces = 0.02;

// Where as few are wanted as there can be, all is done in sweeps.
std::uint64_t left_by_sweeps(const Tiles& tiles) {
  const std::uint64_t wanted = tiles.settings().faces;
  if (wanted == 0) return 0;
  return static_cast<std::uint64_t>(sweeps_beside_faces * static_cast<double>(tiles.faces()) +
                                    sweeps_beside_wanted * static_cast<double>(wanted));
}

// What the collapses of one tile were.
struct TileCollapses {
  std::uint64_t count = 0;
  double largest_error = 0;
};

// What vertices carry, and what each was collapsed into.
struct Followers {
  CarriedValues values;
  CollapsedInto into;

  void collapsed(const Collapse& edge) {
    values.collapsed(edge);
    into.collapsed(edge);
  }
};

struct CollapsedTile {
  TileResult rest;
  TileCollapses done;
};

// TileCollapses collapse(tile number, decimation, followers): of any tile, on any thread.
template <typename Collapse>
CollapsedMesh collapse_tiles(const Tiles& tiles, const Collapse& collapse) {
  const RefineSettings& settings = tiles.settings();
  const MeshLayout layout{settings.state_size(), settings.attributes.size()};
  RoundOutput output(tiles.job(), layout, settings.map, tiles.memory().mesh);
  CollapsedMesh out;
  tiles.for_each<CollapsedTile>(
      0,
      [&](std::size_t number, CollapsedTile& collapsed) {
        Tile tile = tiles.load(number, {true, settings.known_state_size(), layout.attributes});
        TileMesh mesh(std::move(tile.positions), std::move(tile.faces), std::move(tile.locked),
                      false);
        const std::unique_ptr<Decimation> decimation =
            Decimation::make(mesh, tile.state, settings.decimation);
        Followers followers{carried_values(tile, settings.attributes),
                            CollapsedInto(settings.map ? mesh.vertex_count() : 0)};
        collapsed.done = collapse(number, *decimation, followers);
        collapsed.rest = rest_of(tile, mesh, *decimation, followers.values,
                                 settings.map ? &followers.into : nullptr, layout.state);
      },
      [&](std::size_t, CollapsedTile& collapsed) {
        out.collapses += collapsed.done.count;
        out.largest_error = std::max(out.largest_error, collapsed.done.largest_error);
        out.changes.add(collapsed.rest.changes);
        output.append(std::move(collapsed.rest));
      });
  out.whole = output.finish(tiles.tiling(), tiles.incoming().hubs());
  if (tiles.whole().map != nullptr) {
    out.whole.map = composed(tiles.job(), *tiles.whole().map, *out.whole.map,
                             share::round::map(tiles.memory().mesh));
  }
  return out;
}

}  // namespace

CollapsedMesh collapse_nothing(const Tiles& tiles) {
  return collapse_tiles(tiles,
                        [](std::size_t, Decimation&, Followers&) { return TileCollapses{}; });
}

CollapsedMesh collapse_all(const Tiles& tiles, std::uint64_t round, double costliest) {
  CollapseLimits limits{tiles.settings().faces, costliest};
  limits.exact = tiles.settings().decimation.sequence.has_value();
  // Later rounds watch the order of collapses: few are left.
  if (round == 1 && tiles.settings().in_sweeps()) {
    limits.sweeps_to = left_by_sweeps(tiles);
    limits.fine_from = static_cast<std::uint64_t>(RefineSettings::fine_beside_wanted *
                                                  static_cast<double>(tiles.settings().faces));
  }
  ProgressMeter& progress = tiles.job().progress;
  return collapse_tiles(tiles, [&](std::size_t, Decimation& decimation, Followers& followers) {
    TileProgress told(progress);
    std::uint64_t count = 0;
    decimation.run(
        limits,
        [&](const DoneCollapse& done) {
          ++count;
          followers.collapsed(done.edge);
          told.add(done.faces);
        },
        [&progress] { progress.check_cancelled(); });
    return TileCollapses{count, decimation.largest_error()};
  });
}

CollapsedMesh collapse_chosen(const Tiles& tiles, const ChosenCollapses& chosen) {
  return collapse_tiles(tiles, [&](std::size_t tile, Decimation& decimation, Followers& followers) {
    const std::uint64_t count = chosen.counts[tile];
    const std::vector<Collapse> edges = chosen.log->edges(tile, count);
    // Those of a sequence take long.
    const std::size_t at_once = tiles.settings().decimation.sequence ? 256 : edges.size();
    for (std::size_t first = 0; first < edges.size(); first += at_once) {
      tiles.job().progress.check_cancelled();
      decimation.repeat(std::span(edges).subspan(first, std::min(at_once, edges.size() - first)));
    }
    for (const Collapse& edge : edges) followers.collapsed(edge);
    tiles.job().progress.check_cancelled();
    return TileCollapses{count, chosen.log->error(tile, count)};
  });
}

}  // namespace winnow
