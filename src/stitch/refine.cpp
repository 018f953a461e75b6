#include "stitch/refine.hpp"

#include <winnow/error.hpp>

#include "base/parallel.hpp"
#include "stitch/blocked_faces.hpp"
#include "stitch/collapse_log.hpp"
#include "stitch/price_estimate.hpp"
#include "stitch/reorder.hpp"
#include "stitch/saved_mesh.hpp"
#include "stitch/smaller_mesh.hpp"
#include "stitch/tried_tiles.hpp"
#include "stitch/unfolded_tile.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <mutex>
#include <utility>

namespace winnow {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

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
// Of a mesh of one tile so many times the wanted faces, and this part of all, are left to be chosen
// in the order of prices.
constexpr double sweeps_beside_wanted = 1.3;
constexpr double sweeps_beside_faces = 0.02;
// One face in so many may have corners in several tiles; with more, tiles are larger, up to so many
// times.
constexpr std::uint64_t most_seams = 4;
constexpr std::uint64_t largest_tiles = 64;
// How much dearer than the dearest collapse of the last round those of the next may be, before it
// is tried again: with more, and then without a limit.
constexpr double first_headroom = 2;
// The same beside the price that the tiles of the first round will be cut at, as it is estimated.
constexpr double headroom_of_estimate = 2;
constexpr double more_headroom = 64;
// Where the count is missed, a collapse may be so many times as dear as the dearest of a result
// that met it: twice as far off. With 1 four faces in a hundred more are left, hardly nearer to the
// surface; with 64 shapes begin to go (bench/RESULTS.md).
constexpr double headroom_when_blocked = 4;
// Of tiles that are tried for their prices alone.
constexpr unsigned no_attempt = std::numeric_limits<unsigned>::max();

// Whoever asks for an error gets the surface on which it was watched.
bool unfolds(const RefineSettings& settings) {
  return !settings.decimation.error;
}

// Counts of one tile, told to all in steps: threads would get into each other's way at every
// collapse.
class Steps {
 public:
  explicit Steps(ProgressMeter& progress) : progress_(progress) {}
  void add(std::uint64_t faces) {
    pending_ += faces;
    if (pending_ >= 2048) progress_.advance(std::exchange(pending_, 0));
  }

 private:
  ProgressMeter& progress_;
  std::uint64_t pending_ = 0;
};

// What collapsing leaves of a tile: a log, or what is left of the mesh.
std::uint64_t result_memory(const RefineSettings& settings, std::uint64_t faces) {
  const std::uint64_t log = faces / 2 * CollapseLog::entry_size;
  const std::size_t attributes = settings.attributes.size() * sizeof(double);
  const std::uint64_t rest =
      faces / 2 *
      (sizeof(IndexedVertex) + Decimation::state_size(settings.decimation) + attributes);
  return std::max(log, rest);
}

class Refiner {
 public:
  Refiner(Job& job, RefineSettings settings, const RefineMemory& memory, RefineReport& report,
          CheckpointDirectory* checkpoint)
      : job_(job),
        settings_(std::move(settings)),
        memory_(memory),
        report_(report),
        checkpoint_(checkpoint) {}

  ClusteredMesh run(RefinedMesh whole) {
    if (!restore()) whole = collapsed(std::move(whole));
    return unfolded(std::move(whole));
  }

 private:
  RefinedMesh collapsed(RefinedMesh whole) {
    for (++report_.rounds;; ++report_.rounds) {
      const std::uint64_t before = whole.mesh.face_count;
      const auto [tiling, incoming] = cut(whole.mesh);
      if (report_.rounds == 1) report_.tiles = tiling.tiles();
      job_.progress.begin("refine", faces_to_try(before, tiling), "faces");
      RefinedMesh smaller = round(whole, tiling, incoming);
      if (report_.rounds == 1) keep_reference(whole.mesh);
      whole = std::move(smaller);
      settings_.decimation.boundaries_known = true;
      if (whole.mesh.face_count <= settings_.faces) break;
      // One tile has no borders that kept anything. Of several, two rounds that hardly helped say
      // that no other will: one for each way in which the tiles lie.
      if (before - whole.mesh.face_count <= before / 1000) ++idle_;
      if (tiling.tiles() == 1 || idle_ > 1) {
        find_reasons(whole);
        break;
      }
      const bool back = report_.rounds % 2 == 0;
      whole = reorder(job_, std::move(whole), back, state_size(), settings_.attributes.size(),
                      memory_.lists, memory_.mesh);
      keep(whole, false);
    }
    keep(whole, true);
    return whole;
  }

  void find_reasons(const RefinedMesh& whole) {
    report_.stopped_by = StoppedBy::error;
    if (settings_.decimation.error) return;
    const auto [tiling, incoming] = cut(whole.mesh);
    for_each_tile<BlockedFaces>(
        tiling, incoming, 0,
        [&, &tiling = tiling, &incoming = incoming](std::size_t number, BlockedFaces& blocked) {
          blocked =
              blocked_faces(load_tile(whole, tiling, incoming, number, 0, 0), settings_.decimation);
          job_.progress.check_cancelled();
        },
        [&](std::size_t, const BlockedFaces& blocked) { report_.blocked.add(blocked); });
    report_.stopped_by = report_.blocked.reasons().front();
  }

  // A checkpoint keeps it by itself.
  void keep_reference(ClusteredMesh& mesh) {
    if (checkpoint_ != nullptr || !unfolds(settings_)) return;
    reference_.vertices = std::move(mesh.vertices);
    reference_.faces = std::move(mesh.faces);
    reference_.face_count = mesh.face_count;
  }

  // The mesh as it is written: no round goes on from it.
  ClusteredMesh unfolded(RefinedMesh whole) {
    if (!unfolds(settings_) || report_.collapses == 0 || whole.mesh.face_count == 0)
      return std::move(whole.mesh);
    job_.progress.begin("unfold", whole.mesh.face_count, "faces");
    whole.state.reset();
    if (checkpoint_ != nullptr) reference_ = load_reference(job_, *checkpoint_, memory_.mesh);
    const ReferenceMesh reference(job_, reference_, memory_.lists / 4);
    const std::uint64_t ratio = reference_.face_count / whole.mesh.face_count;
    const auto [tiling, incoming] = cut(whole.mesh);
    auto vertices = std::make_unique<VertexIndex>(job_, memory_.mesh);
    for_each_tile<std::vector<IndexedVertex>>(
        tiling, incoming, 0,
        [&, &tiling = tiling, &incoming = incoming](std::size_t number,
                                                    std::vector<IndexedVertex>& moved) {
          Tile tile = load_tile(whole, tiling, incoming, number, 0, 0);
          job_.progress.advance(tile.own_faces);
          moved = unfolded_vertices(std::move(tile), reference, ratio, settings_.decimation.single);
        },
        [&](std::size_t, const std::vector<IndexedVertex>& moved) { vertices->append(moved); });
    vertices->finish();
    whole.mesh.vertices = std::move(vertices);
    return std::move(whole.mesh);
  }

  // Sets what the rounds that a checkpoint holds have left. True where there is nothing more to do.
  bool restore() {
    if (checkpoint_ == nullptr || !checkpoint_->manifest().has("refine.rounds")) return false;
    const Manifest& manifest = checkpoint_->manifest();
    report_.rounds = report_.rounds_before = manifest.number("refine.rounds");
    report_.tiles = manifest.number("refine.tiles");
    report_.collapses = manifest.number("refine.collapses");
    report_.largest_error = manifest.real("refine.largest_error");
    report_.stopped_by = static_cast<StoppedBy>(manifest.number("refine.stopped_by"));
    report_.blocked.topology = manifest.number("refine.blocked.topology");
    report_.blocked.boundaries = manifest.number("refine.blocked.boundaries");
    report_.blocked.hubs = manifest.number("refine.blocked.hubs");
    report_.blocked.pieces = manifest.number("refine.blocked.pieces");
    report_.changes.pieces = manifest.number("refine.pieces");
    report_.changes.area = manifest.real("refine.piece_area");
    report_.changes.handles = manifest.number("refine.handles");
    report_.changes.holes = manifest.number("refine.holes");
    idle_ = static_cast<unsigned>(manifest.number("refine.idle"));
    dearest_ = manifest.real("refine.dearest");
    dearest_allowed_ = manifest.real("refine.dearest_allowed");
    settings_.decimation.boundaries_known = true;
    return manifest.number("refine.done") != 0;
  }

  void keep(const RefinedMesh& whole, bool done) {
    if (checkpoint_ == nullptr) return;
    job_.progress.begin("keep", 0, "bytes");
    save_mesh(*checkpoint_, whole, report_.rounds, unfolds(settings_));
    Manifest& manifest = checkpoint_->manifest();
    manifest.set("refine.rounds", report_.rounds);
    manifest.set("refine.tiles", report_.tiles);
    manifest.set("refine.collapses", report_.collapses);
    manifest.set("refine.largest_error", report_.largest_error);
    manifest.set("refine.stopped_by", static_cast<std::uint64_t>(report_.stopped_by));
    manifest.set("refine.blocked.topology", report_.blocked.topology);
    manifest.set("refine.blocked.boundaries", report_.blocked.boundaries);
    manifest.set("refine.blocked.hubs", report_.blocked.hubs);
    manifest.set("refine.blocked.pieces", report_.blocked.pieces);
    manifest.set("refine.pieces", report_.changes.pieces);
    manifest.set("refine.piece_area", report_.changes.area);
    manifest.set("refine.handles", report_.changes.handles);
    manifest.set("refine.holes", report_.changes.holes);
    manifest.set("refine.idle", std::uint64_t{idle_});
    manifest.set("refine.dearest", dearest_);
    manifest.set("refine.dearest_allowed", dearest_allowed_);
    manifest.set("refine.done", std::uint64_t{done});
    checkpoint_->commit();
  }

  [[nodiscard]] std::size_t state_size() const {
    return Decimation::state_size(settings_.decimation);
  }

  // Of the mesh that a round begins with.
  [[nodiscard]] std::size_t known_state_size() const {
    return settings_.decimation.boundaries_known
               ? state_size()
               : Decimation::first_state_size(settings_.decimation);
  }

  // What a round is going to remove, for its progress: the first of many tiles tries more than it
  // keeps.
  [[nodiscard]] std::uint64_t faces_to_try(std::uint64_t faces, const Tiling& tiling) const {
    const bool deep = report_.rounds == 1 && tiling.tiles() > 1;
    const double left = (deep ? deepest : 1) * static_cast<double>(settings_.faces);
    return faces - std::min(faces, static_cast<std::uint64_t>(left));
  }

  struct Cut {
    Tiling tiling;
    IncomingFaces incoming;
  };

  // Where most faces are longer than tiles, as those of a tube without rings, nothing could go:
  // such a mesh gets larger tiles.
  Cut cut(const ClusteredMesh& mesh) {
    for (std::uint64_t tile_faces = settings_.tile_faces;; tile_faces *= 8) {
      Tiling tiling(mesh, tile_faces);
      IncomingFaces incoming(job_, mesh, tiling, memory_.lists, settings_.hub_faces);
      const bool few = incoming.seam_faces() <= mesh.face_count / most_seams;
      if (few || tiling.tiles() == 1 || tile_faces >= largest_tiles * settings_.tile_faces)
        return {std::move(tiling), std::move(incoming)};
    }
  }

  RefinedMesh round(const RefinedMesh& whole, const Tiling& tiling, const IncomingFaces& incoming) {
    if (whole.mesh.face_count <= settings_.faces) {
      // Nothing goes but vertices without a face; the others get their normals.
      return make_smaller(whole, tiling, incoming, [](std::size_t, Decimation&, CarriedValues&) {});
    }
    if (tiling.tiles() > 1 && settings_.faces == 0 && checkpoint_ != nullptr) {
      const Tried tried = try_all(whole, tiling, incoming, {0, no_limit}, 0);
      return repeat(whole, tiling, incoming, *tried.log, tried.log->all());
    }
    if (tiling.tiles() == 1 || settings_.faces == 0) {
      const RefineReport before = report_;
      RefinedMesh smaller = run_through(whole, tiling, incoming);
      if (smaller.mesh.face_count <= settings_.faces ||
          !find_dearest_allowed(whole, tiling, incoming))
        return smaller;
      report_ = before;
      return run_through(whole, tiling, incoming);
    }
    const bool first = report_.rounds == 1;
    double more = more_headroom;
    unsigned attempt = 0;
    TryLimits limits{first ? deepest : 0,
                     first || dearest_ == 0 ? no_limit : first_headroom * dearest_};
    limits.price = std::min(limits.price, dearest_allowed_);
    Tried tried = try_all(whole, tiling, incoming, limits, attempt);
    for (;;) {
      const CollapseLog& log = *tried.log;
      const std::uint64_t wanted = wanted_now(whole.mesh.face_count, tried.frozen);
      if (log.removed() < wanted && limits.price < dearest_allowed_) {
        limits.price = std::min(limits.price * std::exchange(more, no_limit), dearest_allowed_);
        tried = try_all(whole, tiling, incoming, limits, ++attempt);
        continue;
      }
      if (log.removed() < wanted && !tried.complete_to(limits.price)) {
        limits.share = 0;
        tried = try_all(whole, tiling, incoming, limits, ++attempt, &tried);
        continue;
      }
      if (log.removed() < wanted) find_dearest_allowed(whole, tiling, incoming);
      const double dearest = log.price_of(std::min(wanted, log.removed()));
      dearest_ = std::min(dearest, dearest_allowed_);
      if (tried.complete_to(dearest_))
        return repeat(whole, tiling, incoming, log,
                      dearest_ < dearest ? log.up_to(dearest_) : log.cut(wanted));
      // Some tiles have more to give at this price than they were let: as those that are flat,
      // beside a statue.
      limits = {0, dearest_};
      tried = try_all(whole, tiling, incoming, limits, ++attempt, &tried);
    }
  }

  // In later rounds few collapses are left, of which the order matters; and an error is watched in
  // the order of prices.
  [[nodiscard]] bool in_sweeps() const {
    return report_.rounds == 1 && !settings_.decimation.error;
  }

  // Of a mesh of one tile. Where as few are wanted as there can be, all is done in sweeps.
  [[nodiscard]] std::uint64_t left_by_sweeps(std::uint64_t faces) const {
    if (settings_.faces == 0) return 0;
    return static_cast<std::uint64_t>(sweeps_beside_faces * static_cast<double>(faces) +
                                      sweeps_beside_wanted * static_cast<double>(settings_.faces));
  }

  // What is left when each tile has collapsed what it can: down to the count where it is the only
  // one.
  RefinedMesh run_through(const RefinedMesh& whole, const Tiling& tiling,
                          const IncomingFaces& incoming) {
    return make_smaller(whole, tiling, incoming,
                        [&](std::size_t, Decimation& decimation, CarriedValues& values) {
                          Steps steps(job_.progress);
                          std::uint64_t collapses = 0;
                          CollapseLimits limits{settings_.faces, dearest_allowed_};
                          if (in_sweeps()) limits.sweeps_to = left_by_sweeps(whole.mesh.face_count);
                          decimation.run(
                              limits,
                              [&](const DoneCollapse& done) {
                                ++collapses;
                                values.collapsed(done.edge);
                                steps.add(done.faces);
                              },
                              check_);
                          tell(collapses, decimation.largest_error());
                        });
  }

  // Sets how dear a collapse may be where the count cannot be met: as dear as the dearest would be
  // that met it if nothing were kept. What is left then would cost more than the detail that the
  // count has no room for. False where it is known, or nothing is kept.
  bool find_dearest_allowed(const RefinedMesh& whole, const Tiling& tiling,
                            const IncomingFaces& incoming) {
    DecimationSettings nothing_kept = settings_.decimation;
    nothing_kept.free_topology = true;
    nothing_kept.keep_boundaries = nothing_kept.keep_pieces = false;
    if (dearest_allowed_ < no_limit || settings_.faces == 0 || settings_.decimation.error ||
        settings_.decimation.cost != CollapseCost::quadric || nothing_kept == settings_.decimation)
      return false;
    const DecimationSettings kept = std::exchange(settings_.decimation, nothing_kept);
    const Tried tried = try_all(whole, tiling, incoming, {0, no_limit}, no_attempt);
    settings_.decimation = kept;
    const std::uint64_t wanted = wanted_now(whole.mesh.face_count, tried.frozen);
    dearest_allowed_ =
        headroom_when_blocked * tried.log->price_of(std::min(wanted, tried.log->removed()));
    return true;
  }

  // What is left when so many collapses of each tile are repeated.
  RefinedMesh repeat(const RefinedMesh& whole, const Tiling& tiling, const IncomingFaces& incoming,
                     const CollapseLog& log, const std::vector<std::uint64_t>& counts) {
    return make_smaller(whole, tiling, incoming,
                        [&](std::size_t tile, Decimation& decimation, CarriedValues& values) {
                          const std::vector<Collapse> edges = log.edges(tile, counts[tile]);
                          decimation.repeat(edges);
                          for (const Collapse& edge : edges) values.collapsed(edge);
                          job_.progress.check_cancelled();
                          tell(counts[tile], log.error(tile, counts[tile]));
                        });
  }

  // How many faces a round removes. The first, and each whose borders freeze more than a few of the
  // faces, leaves some to the next: the frozen faces will become fewer in proportion, and it is not
  // known yet which of them are flat.
  [[nodiscard]] std::uint64_t wanted_now(std::uint64_t faces, std::uint64_t frozen) const {
    const auto few = static_cast<std::uint64_t>(few_frozen * static_cast<double>(settings_.faces));
    const bool last = report_.rounds >= last_round || (report_.rounds > 1 && frozen <= few);
    const auto free = static_cast<double>(faces - frozen);
    const double left = left_by_tiles(faces) * free;
    return last || left >= free ? faces - settings_.faces : static_cast<std::uint64_t>(free - left);
  }

  // The part of the faces that can change which a round leaves that is not the last.
  [[nodiscard]] double left_by_tiles(std::uint64_t faces) const {
    return spare * static_cast<double>(settings_.faces) / static_cast<double>(faces);
  }

  void tell(std::uint64_t collapses, double largest_error) {
    const std::scoped_lock lock(reporting_);
    report_.collapses += collapses;
    report_.largest_error = std::max(report_.largest_error, largest_error);
  }

  // Tiles from `first` on in order, several at once while their memory lasts: work(tile number) on
  // any thread, finish in order. While a tile takes long, results of others behind it wait, so that
  // no thread has to.
  template <typename Item, typename Work, typename Finish>
  void for_each_tile(const Tiling& tiling, const IncomingFaces& incoming, std::size_t first,
                     const Work& work, const Finish& finish) {
    const std::uint64_t largest =
        largest_tile(tiling, incoming, [this](std::uint64_t vertices, std::uint64_t faces) {
          return tile_memory(settings_, vertices, faces);
        });
    const std::uint64_t at_once =
        std::clamp<std::uint64_t>(memory_.tiles / largest, 1, job_.threads);
    const Reservation reserved = job_.budget.reserve(at_once * largest, "refining a tile");
    const std::uint64_t result =
        largest_tile(tiling, incoming, [this](std::uint64_t vertices, std::uint64_t faces) {
          return result_memory(settings_, std::max(2 * vertices, faces)) +
                 faces * sizeof(FaceVertices);
        });
    // Where not all threads are at work, each that waits would be one more.
    const std::uint64_t room =
        at_once < job_.threads || at_once == 1 ? 0 : (memory_.tiles - at_once * largest) / result;
    std::uint64_t waiting = std::min<std::uint64_t>(room, (job_.threads + 1) / 2);
    const Reservation kept = job_.budget.try_reserve(waiting * result);
    if (!kept) waiting = 0;
    std::size_t next = first;
    pipeline<std::pair<std::size_t, Item>>(
        at_once + waiting,
        [&](auto& item) {
          item.first = next++;
          return item.first < tiling.tiles();
        },
        [&](auto& item) { work(item.first, item.second); },
        [&](auto& item) { finish(item.first, item.second); });
  }

  struct Tried {
    std::unique_ptr<CollapseLog> log;
    std::uint64_t frozen = 0;     // faces that cannot change because of the borders between tiles
    std::vector<double> reached;  // of each tile: all that costs no more was tried

    [[nodiscard]] bool complete_to(double price) const {
      return std::all_of(reached.begin(), reached.end(),
                         [price](double to) { return to >= price; });
    }
  };

  // How far to try: no tile below this part of its share of the wanted faces, and up to this price.
  struct TryLimits {
    double share, price;
  };

  // Collapses what can be collapsed and writes it down; nothing is changed. `before`: another
  // attempt, whose tiles are taken over where they went as far.
  Tried try_all(const RefinedMesh& whole, const Tiling& tiling, const IncomingFaces& incoming,
                const TryLimits& most, unsigned attempt, const Tried* before = nullptr) {
    Tried all;
    // Two attempts may be there at once.
    all.log = std::make_unique<CollapseLog>(job_, memory_.logs / 2);
    TriedTiles kept(attempt == no_attempt ? nullptr : checkpoint_, report_.rounds, attempt);
    // Only where tiles go beyond all prices: what they do up to a price does not hang on it.
    const double left = left_by_tiles(whole.mesh.face_count);
    PriceEstimate estimate(1 - left);
    const bool estimates = most.share > 0 && left < 1;
    std::size_t known = 0;
    const auto take = [&](const TriedTile& tried) {
      all.log->append(tried.edges, tried.prices);
      all.frozen += tried.frozen;
      all.reached.push_back(tried.reached);
    };
    for (TriedTile tried; known < tiling.tiles() && kept.next(tried); ++known) {
      take(tried);
      job_.progress.advance(tried.prices.empty() ? 0 : tried.prices.back().removed);
    }
    if (report_.rounds == report_.rounds_before + 1) report_.tiles_before += known;
    for_each_tile<TriedTile>(
        tiling, incoming, known,
        [&](std::size_t number, TriedTile& tried) {
          tried.clear();
          if (before != nullptr && before->reached[number] >= most.price) {
            tried.edges = before->log->edges(number, before->log->entries(number));
            tried.prices = before->log->prices(number);
            tried.reached = before->reached[number];
            return;
          }
          Tile tile = load_tile(whole, tiling, incoming, number, known_state_size(), 0);
          TileMesh mesh(std::move(tile.positions), std::move(tile.faces), std::move(tile.locked));
          tried.frozen = tile.frozen;
          const std::unique_ptr<Decimation> decimation =
              Decimation::make(mesh, tile.state, settings_.decimation);
          CollapseLimits limits{0, most.price};
          if (in_sweeps()) limits.sweeps_to = 0;
          if (estimates)
            limits.price = std::min(limits.price, headroom_of_estimate * estimate.price());
          const double share = most.share * static_cast<double>(settings_.faces) /
                               static_cast<double>(whole.mesh.face_count);
          if (share > worth_a_limit) {
            const auto others =
                static_cast<double>(mesh.face_count() - tile.own_faces + tried.frozen);
            limits.faces =
                static_cast<std::uint64_t>(share * static_cast<double>(tile.own_faces) + others);
          }
          std::uint64_t removed = 0;
          Steps steps(job_.progress);
          decimation->run(
              limits,
              [&](const DoneCollapse& done) {
                removed += done.faces;
                tried.edges.push_back(done.edge);
                tried.prices.push_back({done.price, removed, done.error});
                steps.add(done.faces);
              },
              check_);
          if (limits.price < most.price) tried.reached = limits.price;
          if (limits.faces > 0 && mesh.live_faces() <= limits.faces)
            tried.reached =
                std::min(tried.reached, tried.prices.empty() ? 0 : tried.prices.back().price);
          if (estimates) estimate.add(tried.prices, tile.own_faces - tried.frozen);
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

  // What is left when `shrink` has been at every tile.
  template <typename Shrink>
  RefinedMesh make_smaller(const RefinedMesh& whole, const Tiling& tiling,
                           const IncomingFaces& incoming, const Shrink& shrink) {
    RoundOutput smaller(job_, state_size(), settings_.attributes.size(), memory_.mesh);
    for_each_tile<TileResult>(
        tiling, incoming, 0,
        [&](std::size_t number, TileResult& rest) {
          Tile tile = load_tile(whole, tiling, incoming, number, known_state_size(),
                                settings_.attributes.size());
          TileMesh mesh(std::move(tile.positions), std::move(tile.faces), std::move(tile.locked),
                        false);
          const std::unique_ptr<Decimation> decimation =
              Decimation::make(mesh, tile.state, settings_.decimation);
          CarriedValues values = carried_values(tile, settings_.attributes);
          shrink(number, *decimation, values);
          rest = rest_of(tile, mesh, *decimation, values, state_size());
        },
        [&](std::size_t, TileResult& rest) {
          report_.changes.add(rest.changes);
          smaller.append(std::move(rest));
        });
    RefinedMesh out = smaller.finish(tiling, incoming.hubs());
    out.mesh.cells = whole.mesh.cells;
    out.mesh.fused = whole.mesh.fused;
    return out;
  }

  Job& job_;
  RefineSettings settings_;
  RefineMemory memory_;
  RefineReport& report_;
  CheckpointDirectory* checkpoint_;
  std::function<void()> check_ = [this] { job_.progress.check_cancelled(); };
  std::mutex reporting_;
  ClusteredMesh reference_;  // vertices and faces of the mesh that the first round began with
  double dearest_ = 0;       // collapse of the last round
  double dearest_allowed_ = no_limit;
  unsigned idle_ = 0;  // rounds that hardly helped
};

}  // namespace

std::uint64_t tile_memory(const RefineSettings& settings, std::uint64_t vertices,
                          std::uint64_t faces) {
  const std::uint64_t collapsing =
      Tile::memory(vertices, faces, Decimation::state_size(settings.decimation)) +
      Decimation::memory(settings.decimation, vertices) +
      CarriedValues::memory(vertices, settings.attributes.size()) + result_memory(settings, faces);
  return unfolds(settings) ? std::max(collapsing, unfolded_tile_memory(vertices, faces))
                           : collapsing;
}

ClusteredMesh refine(Job& job, RefinedMesh whole, const RefineSettings& settings,
                     const RefineMemory& memory, RefineReport& report,
                     CheckpointDirectory* checkpoint) {
  return Refiner(job, settings, memory, report, checkpoint).run(std::move(whole));
}

}  // namespace winnow
