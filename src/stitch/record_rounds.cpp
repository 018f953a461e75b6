#include "stitch/record_rounds.hpp"

#include "decimate/error_bound.hpp"
#include "decimate/witness_points.hpp"
#include "mesh/saved_mesh.hpp"
#include "stitch/choose_collapses.hpp"
#include "stitch/collapse_recorder.hpp"
#include "stitch/reorder.hpp"
#include "stitch/round_output.hpp"
#include "stitch/saved_records.hpp"
#include "stitch/tiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace winnow {

namespace {

// From one band of costs to the next the faces become so many times fewer: a file that is read up
// to some place is as fine everywhere but for this.
constexpr double band_step = 1.1;
// Of several tiles; fewer splits do not pack well.
constexpr std::uint64_t least_splits = 512;
// Of one part, which is decoded at once.
constexpr std::uint32_t most_splits = 1 << 15;
// What a round leaves of the faces, where there are several tiles.
constexpr double left_by_round = 0.5;
// A round that takes no more than this part of the faces hardly helped. Two of them say that no
// other will.
constexpr std::uint64_t hardly_any = 1000;

// The last of them says how many collapses of each tile there are.
using Bands = std::vector<std::vector<std::uint64_t>>;

struct RecordedTile {
  TileResult rest;
  std::vector<RecordedPart> parts;
  Words words;
  std::vector<std::uint32_t> gone;

  // Keeps what it has allocated.
  void clear() {
    rest = {};
    parts.clear();
    words.clear();
    gone.clear();
  }
};

// One round of one mesh.
class RoundRecorder {
 public:
  RoundRecorder(const Tiles& tiles, const VertexWords& words, bool first)
      : tiles_(tiles), words_(words), first_(first) {}

  StoredMesh run(const ChosenCollapses& chosen, const Bands& bands, RecordedRound& into) {
    const RefineSettings& settings = tiles_.settings();
    const MeshLayout layout{settings.state_size(), settings.attributes.size()};
    RoundOutput output(tiles_.job(), layout, false, tiles_.memory().mesh);
    tiles_.for_each<RecordedTile>(
        0,
        [&](std::size_t number, RecordedTile& recorded) {
          record(number, *chosen.log, bands, recorded);
        },
        [&](std::size_t, RecordedTile& recorded) {
          into.append(std::move(recorded.parts), recorded.words, recorded.gone);
          output.append(std::move(recorded.rest));
        });
    into.finish();
    return output.finish(tiles_.tiling(), tiles_.incoming().hubs());
  }

 private:
  void record(std::size_t number, const CollapseLog& log, const Bands& bands,
              RecordedTile& out) const {
    out.clear();
    const std::vector<Collapse> edges = log.edges(number, bands.back()[number]);
    const std::vector<CollapseLog::Cost> costs = log.costs(number);
    const RefineSettings& settings = tiles_.settings();
    Tile tile =
        tiles_.load(number, {true, settings.known_state_size(), settings.attributes.size()});
    const std::vector<std::uint32_t> numbers = take_numbers(tile);
    TileMesh mesh(std::move(tile.positions), std::move(tile.faces), std::move(tile.locked));
    const std::unique_ptr<Decimation> decimation =
        Decimation::make_watching(mesh, tile.state, settings.decimation);
    CarriedValues values = carried_values(tile, settings.attributes);
    CollapseRecorder recorder(mesh, *decimation, values, words_, settings.decimation.free_topology);
    std::vector<std::uint8_t> gone(mesh.vertex_count(), 0);
    std::uint32_t band = 0;
    const auto add = [&](RecordedCollapse& collapse, double error) {
      for (const VertexNumber v : collapse.gone) gone[v] = 1;
      if (out.parts.empty() || out.parts.back().band != band ||
          out.parts.back().splits == most_splits)
        begin_part(band, out);
      append(collapse, numbers, out);
      out.parts.back().error = std::max(out.parts.back().error, error);
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
      while (i >= bands[band][number]) ++band;
      RecordedCollapse& collapse = recorder.repeat(edges[i]);
      add(collapse, std::max(decimation->needed_error(), error_at(costs[i].cost)));
      if (i % 1024 == 0) tiles_.job().progress.check_cancelled();
    }
    for (VertexNumber v = 0; v < tile.own_vertices; ++v) {
      const bool hub = std::binary_search(tile.hubs.begin(), tile.hubs.end(), v);
      if (!mesh.has_faces(v) && gone[v] == 0 && !hub) add(recorder.leave_out(v), 0);
    }
    if (!out.parts.empty()) out.parts.back().words = out.words.size() - out.parts.back().first_word;
    out.rest = rest_of(tile, mesh, *decimation, values, nullptr, settings.state_size());
  }

  // By the points that vertices remember in a round. Costs that are no distance know no error.
  [[nodiscard]] double error_at(double cost) const {
    return facts_of(tiles_.settings().decimation.cost).bounds_error
               ? ErrorBound::needed_by(WitnessPoints::farthest_at(cost))
               : std::numeric_limits<double>::infinity();
  }

  // What the vertices of a tile are called from the first round to the last.
  std::vector<std::uint32_t> take_numbers(Tile& tile) const {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(tile.vertices.size() + tile.others.size());
    for (IndexedVertex& vertex : tile.vertices) {
      if (first_) vertex.unused = static_cast<std::uint32_t>(tile.first_vertex + numbers.size());
      numbers.push_back(vertex.unused);
    }
    if (first_) {
      numbers.insert(numbers.end(), tile.others.begin(), tile.others.end());
    } else if (!tile.others.empty()) {
      VertexIndex::Reader reader(*tiles_.whole().vertices);
      for (const std::uint32_t v : tile.others) numbers.push_back(reader.at(v).unused);
    }
    return numbers;
  }

  static void begin_part(std::uint32_t band, RecordedTile& out) {
    const std::uint64_t first_word = out.words.size();
    if (!out.parts.empty()) out.parts.back().words = first_word - out.parts.back().first_word;
    RecordedPart part;
    part.band = band;
    part.first_word = first_word;
    part.first_gone = out.gone.size();
    out.parts.push_back(part);
  }

  static void append(RecordedCollapse& collapse, const std::vector<std::uint32_t>& numbers,
                     RecordedTile& out) {
    collapse.for_each_vertex([&](std::uint32_t& v) { v = numbers[v]; });
    RecordedPart& part = out.parts.back();
    ++part.splits;
    part.vertices += static_cast<std::uint32_t>(collapse.gone.size());
    part.faces += static_cast<std::uint32_t>(collapse.ringed.split.restored.size());
    pack(collapse, out.words);
    // Read from the back: the first comes first then.
    out.gone.insert(out.gone.end(), collapse.gone.rbegin(), collapse.gone.rend());
  }

  const Tiles& tiles_;
  const VertexWords& words_;
  bool first_;
};

Bands bands_of(const ChosenCollapses& chosen, const Tiles& tiles, std::uint64_t removed) {
  std::uint64_t collapses = 0;
  for (const std::uint64_t count : chosen.counts) collapses += count;
  const auto before = static_cast<double>(tiles.faces());
  const double left = std::max(1.0, before - static_cast<double>(removed));
  auto count = static_cast<std::uint64_t>(std::ceil(std::log(before / left) / std::log(band_step)));
  if (tiles.count() > 1) count = std::min(count, collapses / (tiles.count() * least_splits));
  Bands bands;
  for (std::uint64_t i = 1; i < count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count);
    const double wanted = before - before * std::pow(left / before, part);
    std::vector<std::uint64_t> cut = chosen.log->cut(static_cast<std::uint64_t>(wanted));
    for (std::size_t tile = 0; tile < cut.size(); ++tile)
      cut[tile] = std::min(cut[tile], chosen.counts[tile]);
    bands.push_back(std::move(cut));
  }
  bands.push_back(chosen.counts);
  return bands;
}

std::uint64_t removed_by(const ChosenCollapses& chosen) {
  std::uint64_t removed = 0;
  for (std::size_t tile = 0; tile < chosen.counts.size(); ++tile) {
    if (chosen.counts[tile] > 0)
      removed += chosen.log->costs(tile)[chosen.counts[tile] - 1].removed;
  }
  return removed;
}

// Fine to coarse: each round takes about half as much as the one before.
std::uint64_t memory_of_round(std::uint64_t memory, std::uint64_t rounds_before) {
  return std::max(memory >> std::min<std::uint64_t>(rounds_before + 1, 20), mebibyte / 4);
}

// The loop of rounds.
class RoundsRecorder {
 public:
  RoundsRecorder(Job& job, RefineSettings settings, const VertexWords& words,
                 const RefineMemory& memory, std::uint64_t record_memory,
                 CheckpointDirectory* checkpoint)
      : job_(job),
        settings_(std::move(settings)),
        words_(words),
        memory_(memory),
        record_memory_(record_memory),
        checkpoint_(checkpoint),
        base_(settings_.faces) {
    settings_.record_bytes = recorded_bytes(words.width());
  }

  RecordedMesh run(StoredMesh whole) {
    state_.done = whole.face_count <= base_;
    if (checkpoint_ != nullptr && saved_records(*checkpoint_) > 0) load();
    while (!state_.done) whole = round(std::move(whole));
    out_.round_count = out_.rounds.size();
    out_.collapses = state_.collapses;
    out_.base = std::move(whole);
    return std::move(out_);
  }

 private:
  void load() {
    state_ = load_record_state(*checkpoint_);
    out_.rounds_before = saved_records(*checkpoint_);
    for (std::uint64_t i = 0; i < out_.rounds_before; ++i)
      out_.rounds.push_back(load_record(*checkpoint_, i + 1, memory_of_round(record_memory_, i)));
    settings_.decimation.boundaries_known = true;
  }

  StoredMesh round(StoredMesh whole) {
    const std::uint64_t before = whole.face_count;
    settings_.faces =
        std::max(base_, static_cast<std::uint64_t>(left_by_round * static_cast<double>(before)));
    RecordedRound recorded(job_, memory_of_round(record_memory_, out_.rounds.size()));
    bool one_tile = false;
    {
      const Tiles tiles(job_, whole, settings_, memory_);
      one_tile = tiles.count() == 1;
      const ChosenCollapses chosen = choose(tiles);
      const Bands bands = bands_of(chosen, tiles, removed_by(chosen));
      for (const std::uint64_t count : bands.back()) state_.collapses += count;
      RoundRecorder recorder(tiles, words_, out_.rounds.empty());
      whole = recorder.run(chosen, bands, recorded);
    }
    out_.rounds.push_back(std::move(recorded));
    settings_.decimation.boundaries_known = true;
    if (before - whole.face_count <= before / hardly_any) ++state_.idle;
    state_.done = one_tile || state_.idle > 1 || whole.face_count <= base_;
    if (!state_.done) {
      const bool back = out_.rounds.size() % 2 == 0;
      whole = reorder(job_, std::move(whole), back, memory_.lists, memory_.mesh);
    }
    keep(whole);
    return whole;
  }

  ChosenCollapses choose(const Tiles& tiles) {
    // Every round is like the first of a run: the mesh is another one.
    KnownCosts costs;
    CollapseChooser chooser(tiles, 1, costs, checkpoint_, out_.rounds.size() + 1);
    job_.progress.begin("refine", chooser.faces_to_try(), "faces");
    ChosenCollapses chosen = tiles.count() > 1 ? chooser.cheapest() : chooser.all();
    if (out_.rounds.size() == out_.rounds_before) out_.tiles_before = chooser.tiles_before();
    if (tiles.count() > 1) return chosen;
    const std::uint64_t most = tiles.faces() - base_;
    if (chosen.log->removed() > most) chosen.counts = chosen.log->cut(most);
    return chosen;
  }

  void keep(const StoredMesh& whole) {
    if (checkpoint_ == nullptr) return;
    job_.progress.begin("keep", 0, "bytes");
    const std::uint64_t rounds = out_.rounds.size();
    save_mesh(*checkpoint_, whole, rounds, false);
    save_record(job_, *checkpoint_, rounds, out_.rounds.back(), state_);
    checkpoint_->commit();
  }

  Job& job_;
  RefineSettings settings_;
  const VertexWords& words_;
  RefineMemory memory_;
  std::uint64_t record_memory_;
  CheckpointDirectory* checkpoint_;
  std::uint64_t base_;  // faces
  RecordState state_;
  RecordedMesh out_;
};

}  // namespace

RecordedMesh record_rounds(Job& job, StoredMesh whole, RefineSettings settings,
                           const VertexWords& words, const RefineMemory& memory,
                           std::uint64_t record_memory, CheckpointDirectory* checkpoint) {
  return RoundsRecorder(job, std::move(settings), words, memory, record_memory, checkpoint)
      .run(std::move(whole));
}

}  // namespace winnow
