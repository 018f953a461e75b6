#include "stitch/saved_rounds.hpp"

#include <cstdint>

namespace winnow {

namespace {

constexpr const char* rounds_key = "refine.rounds";

}  // namespace

void save_rounds(Manifest& manifest, const RoundsState& state) {
  const RefineReport& report = state.report;
  manifest.set(rounds_key, report.rounds);
  manifest.set("refine.tiles", report.tiles);
  manifest.set("refine.collapses", report.collapses);
  manifest.set("refine.largest_error", report.largest_error);
  manifest.set("refine.stopped_by", static_cast<std::uint64_t>(report.stopped_by));
  manifest.set("refine.blocked.topology", report.blocked.topology);
  manifest.set("refine.blocked.boundaries", report.blocked.boundaries);
  manifest.set("refine.blocked.hubs", report.blocked.hubs);
  manifest.set("refine.blocked.pieces", report.blocked.pieces);
  manifest.set("refine.pieces", report.changes.pieces);
  manifest.set("refine.piece_area", report.changes.area);
  manifest.set("refine.handles", report.changes.handles);
  manifest.set("refine.holes", report.changes.holes);
  manifest.set("refine.joined", report.joined);
  manifest.set("refine.idle", std::uint64_t{state.idle});
  manifest.set("refine.dearest", state.prices.dearest);
  manifest.set("refine.dearest_allowed", state.prices.dearest_allowed);
  manifest.set("refine.done", std::uint64_t{state.done});
}

bool holds_rounds(const Manifest& manifest) {
  return manifest.has(rounds_key);
}

RoundsState load_rounds(const Manifest& manifest) {
  RoundsState state;
  RefineReport& report = state.report;
  report.rounds = report.rounds_before = manifest.number(rounds_key);
  report.tiles = manifest.number("refine.tiles");
  report.collapses = manifest.number("refine.collapses");
  report.largest_error = manifest.real("refine.largest_error");
  report.stopped_by = static_cast<StoppedBy>(manifest.number("refine.stopped_by"));
  report.blocked.topology = manifest.number("refine.blocked.topology");
  report.blocked.boundaries = manifest.number("refine.blocked.boundaries");
  report.blocked.hubs = manifest.number("refine.blocked.hubs");
  report.blocked.pieces = manifest.number("refine.blocked.pieces");
  report.changes.pieces = manifest.number("refine.pieces");
  report.changes.area = manifest.real("refine.piece_area");
  report.changes.handles = manifest.number("refine.handles");
  report.changes.holes = manifest.number("refine.holes");
  report.joined = manifest.number("refine.joined");
  state.idle = static_cast<unsigned>(manifest.number("refine.idle"));
  state.prices.dearest = manifest.real("refine.dearest");
  state.prices.dearest_allowed = manifest.real("refine.dearest_allowed");
  state.done = manifest.number("refine.done") != 0;
  return state;
}

}  // namespace winnow
