#include "stitch/saved_rounds.hpp"

#include <cstdint>
#include <string>

namespace winnow {

namespace {

constexpr const char* level_count = "refine.levels";  // that are done, before the one at work

// Keys of what the level at work tells, or one before it.
std::string level_key(std::size_t level, const char* what) {
  return "refine.level-" + std::to_string(level) + "." + what;
}

void save_report(Manifest& manifest, std::size_t level, const RefineReport& report) {
  const auto set = [&](const char* what, const auto& value) {
    manifest.set(level_key(level, what), value);
  };
  set("rounds", report.rounds);
  set("tiles", report.tiles);
  set("collapses", report.collapses);
  set("largest_error", report.largest_error);
  set("stopped_by", static_cast<std::uint64_t>(report.stopped_by));
  set("blocked.topology", report.blocked.topology);
  set("blocked.boundaries", report.blocked.boundaries);
  set("blocked.hubs", report.blocked.hubs);
  set("blocked.pieces", report.blocked.pieces);
  set("pieces", report.changes.pieces);
  set("piece_area", report.changes.area);
  set("handles", report.changes.handles);
  set("holes", report.changes.holes);
  set("joined", report.joined);
}

}  // namespace

void RoundsState::next_level() {
  const std::uint64_t before = collapses + report.collapses;
  *this = {{}, {}, 0, false, level + 1, stage, before};
}

void save_rounds(Manifest& manifest, const RoundsState& state) {
  save_report(manifest, state.level, state.report);
  manifest.set(level_count, std::uint64_t{state.level});
  manifest.set("refine.stage", state.stage);
  manifest.set("refine.collapses", state.collapses);
  manifest.set("refine.idle", std::uint64_t{state.idle});
  manifest.set("refine.costliest", state.costs.costliest);
  manifest.set("refine.highest_cost_allowed", state.costs.highest_cost_allowed);
  manifest.set("refine.done", std::uint64_t{state.done});
}

bool holds_rounds(const Manifest& manifest) {
  return manifest.has(level_count);
}

RefineReport load_level_report(const Manifest& manifest, std::size_t level) {
  const auto number = [&](const char* what) { return manifest.number(level_key(level, what)); };
  const auto real = [&](const char* what) { return manifest.real(level_key(level, what)); };
  RefineReport report;
  report.rounds = report.rounds_before = number("rounds");
  report.tiles = number("tiles");
  report.collapses = number("collapses");
  report.largest_error = real("largest_error");
  report.stopped_by = static_cast<StoppedBy>(number("stopped_by"));
  report.blocked.topology = number("blocked.topology");
  report.blocked.boundaries = number("blocked.boundaries");
  report.blocked.hubs = number("blocked.hubs");
  report.blocked.pieces = number("blocked.pieces");
  report.changes.pieces = number("pieces");
  report.changes.area = real("piece_area");
  report.changes.handles = number("handles");
  report.changes.holes = number("holes");
  report.joined = number("joined");
  return report;
}

RoundsState load_rounds(const Manifest& manifest) {
  RoundsState state;
  state.level = manifest.number(level_count);
  state.report = load_level_report(manifest, state.level);
  state.stage = manifest.number("refine.stage");
  state.collapses = manifest.number("refine.collapses");
  state.idle = static_cast<unsigned>(manifest.number("refine.idle"));
  state.costs.costliest = manifest.real("refine.costliest");
  state.costs.highest_cost_allowed = manifest.real("refine.highest_cost_allowed");
  state.done = manifest.number("refine.done") != 0;
  return state;
}

}  // namespace winnow
