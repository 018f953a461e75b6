#include "stitch/choose_collapses.hpp"

#include "base/memory_shares.hpp"
#include "stitch/cost_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace winnow {

namespace {

constexpr double no_limit = KnownCosts::no_limit;

// The first round leaves so many times the faces that are wanted, the later rounds the rest: their
// borders keep faces that are denser than others by no more than this.
constexpr double spare = 1.03;
// Part of a tile's faces that is worth not to be tried.
constexpr double worth_a_limit = 1.0 / 64;
// Part of the wanted faces that the last round's borders may freeze, and the round that is the last
// in any case.
constexpr double few_frozen = 0.25;
constexpr std::uint64_t last_round = 4;
// No tile goes below this part of its share of the wanted faces in the first round: what flat tiles
// can give beyond is left to the later rounds.
constexpr double deepest = 1.0 / 4;
// The same where a round takes half of the faces: tiles differ less then.
constexpr double deepest_of_recorded = 0.6;
// How much costlier than the costliest collapse of the last round those of the next may be, before
// it is tried again: with more, and then without a limit.
constexpr double first_headroom = 2;
// The same beside the cost that the tiles of the first round will be cut at, as it is estimated.
constexpr double headroom_of_estimate = 4;
// The same where a round takes half of the faces.
constexpr double headroom_of_recorded = 1.5;
constexpr double more_headroom = 64;
// Where the count is missed, a collapse may be twice as far off as the costliest of a result that
// met it. With as far off, four faces in a hundred more are left, hardly nearer to the surface;
// with eight times as far off, shapes begin to go (bench/RESULTS.md).
double headroom_when_blocked(Refine cost) {
  // A swept volume grows with the distance, the others with its square.
  return cost == Refine::volume ? 2 : 4;
}
// In later rounds few collapses are left, of which the order matters: what costs no more than this
// part of the costliest collapse of the last round is collapsed in sweeps.
constexpr double sweeps_beside_costliest = 0.25;

// All that costs no more was tried, where the faces left ended it: others may cost as much as the
// last. Where nothing costs anything a tile has given enough.
double complete_below_last(const std::vector<CollapseLog::Cost>& costs) {
  const double last = costs.empty() ? 0 : costs.back().cost;
  return last > 0 ? std::nextafter(last, 0.0) : 0;
}

float float_below(double error) {
  const auto nearest = static_cast<float>(error);
  return static_cast<double>(nearest) > error ? std::nextafter(nearest, 0.0F) : nearest;
}

}  // namespace

CollapseChooser::CollapseChooser(const Tiles& tiles, std::uint64_t round, KnownCosts& costs,
                                 const CheckpointDirectory* checkpoint, std::uint64_t kept_as)
    : tiles_(tiles),
      settings_(tiles.settings()),
      round_(round),
      costs_(costs),
      checkpoint_(checkpoint),
      kept_as_(kept_as),
      sweeps_cost_(round == 1 ? no_limit : sweeps_beside_costliest * costs.costliest) {}

std::uint64_t CollapseChooser::faces_to_try() const {
  const bool deep = round_ == 1 && tiles_.count() > 1;
  const double left = (deep ? deepest_share() : 1) * static_cast<double>(settings_.faces);
  return tiles_.faces() - std::min(tiles_.faces(), static_cast<std::uint64_t>(left));
}

ChosenCollapses CollapseChooser::all() {
  Tried tried = try_all({0, no_limit});
  std::vector<std::uint64_t> counts = tried.log->all();
  return {std::move(tried.log), std::move(counts)};
}

ChosenCollapses CollapseChooser::cheapest() {
  const bool first = round_ == 1;
  double more = more_headroom;
  TryLimits limits{first ? deepest_share() : 0,
                   first || costs_.costliest == 0 ? no_limit : first_headroom * costs_.costliest};
  limits.cost = std::min(limits.cost, costs_.highest_cost_allowed);
  Tried tried = try_all(limits);
  for (;;) {
    const CollapseLog& log = *tried.log;
    const std::uint64_t wanted = wanted_now(tried.frozen);
    if (log.removed() < wanted && limits.cost < costs_.highest_cost_allowed) {
      limits.cost =
          std::min(limits.cost * std::exchange(more, no_limit), costs_.highest_cost_allowed);
      tried = try_all(limits);
      continue;
    }
    if (log.removed() < wanted && !tried.complete_to(limits.cost)) {
      limits.share = 0;
      tried = try_all(limits, &tried);
      continue;
    }
    if (log.removed() < wanted) find_highest_cost_allowed();
    const double costliest = log.cost_of(std::min(wanted, log.removed()));
    costs_.costliest = std::min(costliest, costs_.highest_cost_allowed);
    if (tried.complete_to(costs_.costliest)) {
      std::vector<std::uint64_t> counts =
          costs_.costliest < costliest ? log.up_to(costs_.costliest) : log.cut(wanted);
      return {std::move(tried.log), std::move(counts)};
    }
    // Some tiles have more to give at this cost than they were let: as those that are flat, beside
    // a statue.
    limits = {0, costs_.costliest};
    tried = try_all(limits, &tried);
  }
}

bool CollapseChooser::find_highest_cost_allowed() {
  DecimationSettings nothing_kept = settings_.decimation;
  nothing_kept.free_topology = true;
  nothing_kept.keep_boundaries = nothing_kept.keep_pieces = false;
  if (costs_.highest_cost_allowed < no_limit || settings_.faces == 0 ||
      settings_.decimation.error || settings_.decimation.sequence ||
      nothing_kept == settings_.decimation)
    return false;
  const Tried tried = try_all({0, no_limit}, nothing_kept, TriedTiles(nullptr, round_, 0), nullptr);
  const std::uint64_t wanted = wanted_now(tried.frozen);
  costs_.highest_cost_allowed = headroom_when_blocked(settings_.decimation.cost) *
                                tried.log->cost_of(std::min(wanted, tried.log->removed()));
  return true;
}

// How many faces a round removes. The first, and each whose borders freeze more than a few of the
// faces, leaves some to the next: the frozen faces will become fewer in proportion, and it is not
// known yet which of them are flat.
std::uint64_t CollapseChooser::wanted_now(std::uint64_t frozen) const {
  const auto few = static_cast<std::uint64_t>(few_frozen * static_cast<double>(settings_.faces));
  const bool last = round_ >= last_round || (round_ > 1 && frozen <= few);
  const auto free = static_cast<double>(tiles_.faces() - frozen);
  const double left = left_by_tiles() * free;
  return last || left >= free ? tiles_.faces() - settings_.faces
                              : static_cast<std::uint64_t>(free - left);
}

double CollapseChooser::headroom_of_estimates() const {
  return settings_.records() ? headroom_of_recorded : headroom_of_estimate;
}

double CollapseChooser::deepest_share() const {
  return settings_.records() ? deepest_of_recorded : deepest;
}

// The part of the faces that can change which a round leaves that is not the last.
double CollapseChooser::left_by_tiles() const {
  return spare * static_cast<double>(settings_.faces) / static_cast<double>(tiles_.faces());
}

bool CollapseChooser::Tried::complete_to(double cost) const {
  return std::all_of(reached.begin(), reached.end(), [cost](double to) { return to >= cost; });
}

CollapseChooser::Tried CollapseChooser::try_all(const TryLimits& most, const Tried* before) {
  return try_all(most, settings_.decimation, TriedTiles(checkpoint_, kept_as_, attempts_++),
                 before);
}

CollapseChooser::Tried CollapseChooser::try_all(const TryLimits& most,
                                                const DecimationSettings& settings, TriedTiles kept,
                                                const Tried* before) {
  ProgressMeter& progress = tiles_.job().progress;
  Tried all;
  // Two attempts may be there at once.
  all.log =
      std::make_unique<CollapseLog>(tiles_.job(), share::refine::attempt(tiles_.memory().logs));
  // Only where tiles go beyond all costs: what they do up to a cost does not hang on it.
  const double left = left_by_tiles();
  CostEstimate estimate(1 - left);
  const bool estimates = most.share > 0 && left < 1;
  std::size_t known = 0;
  const auto take = [&](const TriedTile& tried) {
    all.log->append(tried.edges, tried.costs);
    all.frozen += tried.frozen;
    all.reached.push_back(tried.reached);
  };
  for (TriedTile tried; known < tiles_.count() && kept.next(tried); ++known) {
    take(tried);
    progress.advance(tried.costs.empty() ? 0 : tried.costs.back().removed);
  }
  tiles_before_ += known;
  tiles_.for_each<TriedTile>(
      known,
      [&](std::size_t number, TriedTile& tried) {
        tried.clear();
        if (before != nullptr && before->reached[number] >= most.cost) {
          tried.edges = before->log->edges(number, before->log->entries(number));
          tried.costs = before->log->costs(number);
          tried.reached = before->reached[number];
          return;
        }
        Tile tile = tiles_.load(number, {false, settings_.choosing_state_size(), 0});
        TileMesh mesh(std::move(tile.positions), std::move(tile.faces), std::move(tile.locked),
                      false);
        tried.frozen = tile.frozen;
        const std::unique_ptr<Decimation> decimation = Decimation::make(mesh, tile.state, settings);
        CollapseLimits limits{0, most.cost};
        const auto own = static_cast<double>(tile.own_faces);
        const auto others = static_cast<double>(mesh.face_count() - tile.own_faces + tried.frozen);
        if (settings_.in_sweeps() && sweeps_cost_ > 0) {
          limits.sweeps_to = 0;
          limits.sweeps_cost = sweeps_cost_;
          limits.fine_from = static_cast<std::uint64_t>(
              RefineSettings::fine_beside_wanted * left / spare * own + others);
        }
        if (estimates)
          limits.cost = std::min(limits.cost, headroom_of_estimates() * estimate.cost());
        const double share =
            most.share * static_cast<double>(settings_.faces) / static_cast<double>(tiles_.faces());
        if (share > worth_a_limit) limits.faces = static_cast<std::uint64_t>(share * own + others);
        std::uint32_t removed = 0;
        TileProgress told(progress);
        decimation->run(
            limits,
            [&](const DoneCollapse& done) {
              removed += done.faces;
              tried.edges.push_back(done.edge);
              tried.costs.push_back({done.cost, removed, float_below(done.error)});
              told.add(done.faces);
            },
            [&progress] { progress.check_cancelled(); });
        if (limits.cost < most.cost) tried.reached = limits.cost;
        if (limits.faces > 0 && mesh.live_faces() <= limits.faces)
          tried.reached = std::min(tried.reached, complete_below_last(tried.costs));
        if (estimates) estimate.add(tried.costs, tile.own_faces - tried.frozen);
      },
      [&](std::size_t, const TriedTile& tried) {
        take(tried);
        kept.append(tried);
      });
  all.log->finish();
  // Frozen faces hang on the tiles alone.
  if (before != nullptr) all.frozen = before->frozen;
  return all;
}

}  // namespace winnow
