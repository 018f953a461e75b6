#include "stitch/refine.hpp"

#include "base/memory_shares.hpp"
#include "mesh/saved_mesh.hpp"
#include "stitch/apply_collapses.hpp"
#include "stitch/blocked_faces.hpp"
#include "stitch/choose_collapses.hpp"
#include "stitch/join_vertices.hpp"
#include "stitch/reorder.hpp"
#include "stitch/saved_rounds.hpp"
#include "stitch/tiles.hpp"
#include "stitch/unfolded_mesh.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace winnow {

namespace {

// The loop of rounds.
class Refiner {
 public:
  Refiner(Job& job, RefineSettings settings, const RefineMemory& memory,
          CheckpointDirectory* checkpoint, const MoveVertices& move)
      : job_(job),
        settings_(std::move(settings)),
        memory_(memory),
        checkpoint_(checkpoint),
        move_(move) {}

  void run(StoredMesh whole, std::span<const LevelGoal> goals, const TakeLevel& take) {
    std::size_t level = 0;
    if (checkpoint_ != nullptr && holds_rounds(checkpoint_->manifest())) {
      state_ = load_rounds(checkpoint_->manifest());
      settings_.decimation.boundaries_known = true;
      for (; level < state_.level; ++level) {
        set(goals[level]);
        StoredMesh before = load_level(job_, *checkpoint_, level, memory_.mesh);
        give(before, load_level_report(checkpoint_->manifest(), level), take);
      }
    }
    for (;;) {
      set(goals[level]);
      while (!state_.done) whole = round(std::move(whole));
      const bool last = ++level == goals.size();
      // That of a sequence holds the other frames.
      if (last && !settings_.decimation.sequence) whole.state.reset();
      give(whole, state_.report, take);
      if (last) return;
      state_.next_level();
    }
  }

  // Vertices and faces of the mesh that the first round began with, where they were kept.
  StoredMesh take_reference() {
    if (checkpoint_ != nullptr) return load_reference(job_, *checkpoint_, memory_.mesh);
    return std::move(reference_);
  }

 private:
  void set(const LevelGoal& goal) {
    settings_.faces = goal.faces;
    settings_.decimation.error.reset();
    if (goal.error > 0) settings_.decimation.error = goal.error;
  }

  StoredMesh round(StoredMesh whole) {
    RefineReport& report = state_.report;
    const std::uint64_t before = whole.face_count;
    ++report.rounds;
    bool one_tile = false;
    {
      const Tiles tiles(job_, whole, settings_, memory_);
      one_tile = tiles.count() == 1;
      if (report.rounds == 1) report.tiles = tiles.count();
      CollapsedMesh collapsed = collapse(tiles);
      report.collapses += collapsed.collapses;
      report.largest_error = std::max(report.largest_error, collapsed.largest_error);
      report.changes.add(collapsed.changes);
      if (++state_.stage == 1) keep_reference(whole);
      whole = std::move(collapsed.whole);
    }
    settings_.decimation.boundaries_known = true;
    state_.done = whole.face_count <= settings_.faces;
    if (!state_.done) {
      // One tile has no borders that kept anything. Of several, two rounds that hardly helped say
      // that no other will: one for each way in which the tiles lie.
      if (before - whole.face_count <= before / 1000) ++state_.idle;
      state_.done = one_tile || state_.idle > 1;
      if (state_.done) {
        if (!join(whole)) find_reasons(whole);
      } else {
        const bool back = report.rounds % 2 == 0;
        whole = reorder(job_, std::move(whole), back, memory_.lists, memory_.mesh);
      }
    }
    keep(whole);
    return whole;
  }

  CollapsedMesh collapse(const Tiles& tiles) {
    RefineReport& report = state_.report;
    CollapseChooser chooser(tiles, report.rounds, state_.costs, checkpoint_, report.rounds);
    job_.progress.begin("refine", chooser.faces_to_try(), "faces");
    if (tiles.faces() <= settings_.faces) return collapse_nothing(tiles);
    const bool all = settings_.faces == 0;
    if (tiles.count() == 1 || (all && checkpoint_ == nullptr)) {
      CollapsedMesh collapsed =
          collapse_all(tiles, report.rounds, state_.costs.highest_cost_allowed);
      if (collapsed.whole.face_count <= settings_.faces || !chooser.find_highest_cost_allowed())
        return collapsed;
      return collapse_all(tiles, report.rounds, state_.costs.highest_cost_allowed);
    }
    const ChosenCollapses chosen = all ? chooser.all() : chooser.cheapest();
    if (report.rounds == report.rounds_before + 1) report.tiles_before += chooser.tiles_before();
    return collapse_chosen(tiles, chosen);
  }

  // Where nothing is to be kept, the count is met whatever the mesh is.
  bool join(StoredMesh& whole) {
    const DecimationSettings& rules = settings_.decimation;
    if (!rules.free_topology || rules.error || rules.keep_boundaries || rules.keep_pieces)
      return false;
    const std::uint64_t before = whole.vertices->size();
    job_.progress.begin("join vertices", 0, "faces");
    if (!join_vertices(job_, whole, settings_.faces, share::refine::joined(memory_.lists),
                       memory_.mesh))
      return false;
    state_.report.joined = before - whole.vertices->size();
    return true;
  }

  void find_reasons(const StoredMesh& whole) {
    RefineReport& report = state_.report;
    report.stopped_by = StoppedBy::error;
    if (settings_.decimation.error) return;
    const Tiles tiles(job_, whole, settings_, memory_);
    tiles.for_each<BlockedFaces>(
        0,
        [&](std::size_t number, BlockedFaces& blocked) {
          blocked = blocked_faces(tiles.load(number, {.records = false}), settings_.decimation);
          job_.progress.check_cancelled();
        },
        [&](std::size_t, const BlockedFaces& blocked) { report.blocked.add(blocked); });
    report.stopped_by = report.blocked.reasons().front();
  }

  // Of the frames of a sequence, which are unfolded one by one, whoever writes them needs it.
  [[nodiscard]] bool needs_reference() const {
    return settings_.unfolds() || settings_.decimation.sequence;
  }

  // A checkpoint keeps it by itself.
  void keep_reference(StoredMesh& mesh) {
    if (checkpoint_ != nullptr || !needs_reference()) return;
    reference_.vertices = std::move(mesh.vertices);
    reference_.faces = std::move(mesh.faces);
    reference_.face_count = mesh.face_count;
  }

  void keep(const StoredMesh& whole) {
    if (checkpoint_ == nullptr) return;
    job_.progress.begin("keep", 0, "bytes");
    save_mesh(*checkpoint_, whole, state_.stage, needs_reference());
    save_rounds(checkpoint_->manifest(), state_);
    if (state_.done) keep_level(*checkpoint_, state_.level);
    checkpoint_->commit();
  }

  // The mesh as it is written is lent to `take`: no round goes on from it.
  void give(StoredMesh& whole, const RefineReport& report, const TakeLevel& take) {
    const bool changed = state_.collapses + state_.report.collapses > 0;
    if (!settings_.unfolds() || !changed || whole.face_count == 0) return take(whole, report);
    std::unique_ptr<VertexIndex> collapsed = moved(whole);
    take(whole, report);
    whole.vertices = std::move(collapsed);
  }

  // Moves vertices and returns them as they were.
  std::unique_ptr<VertexIndex> moved(StoredMesh& whole) {
    if (checkpoint_ != nullptr) reference_ = load_reference(job_, *checkpoint_, memory_.mesh);
    std::unique_ptr<VertexIndex> before;
    {
      const ReferenceMesh reference(job_, reference_, share::refine::boxes(memory_.lists));
      if (move_) before = move_(whole, reference);
      job_.progress.begin("unfold", whole.face_count, "faces");
      std::unique_ptr<VertexIndex> folded = std::exchange(
          whole.vertices, unfolded_vertices(job_, whole, reference, settings_, memory_));
      if (before == nullptr) before = std::move(folded);
    }
    if (checkpoint_ != nullptr) reference_ = {};
    return before;
  }

  Job& job_;
  RefineSettings settings_;
  RefineMemory memory_;
  CheckpointDirectory* checkpoint_;
  const MoveVertices& move_;
  RoundsState state_;
  StoredMesh reference_;  // vertices and faces of the mesh that the first round began with
};

}  // namespace

Refined refine(Job& job, StoredMesh whole, const RefineSettings& settings,
               const RefineMemory& memory, CheckpointDirectory* checkpoint) {
  const LevelGoal goal{settings.faces, settings.decimation.error.value_or(0)};
  Refined out;
  const MoveVertices none;
  Refiner refiner(job, settings, memory, checkpoint, none);
  refiner.run(std::move(whole), std::span(&goal, 1),
              [&](StoredMesh& mesh, const RefineReport& report) {
                out.mesh = std::move(mesh);
                out.report = report;
              });
  if (settings.decimation.sequence) out.reference = refiner.take_reference();
  return out;
}

void refine_levels(Job& job, StoredMesh whole, const RefineSettings& settings,
                   std::span<const LevelGoal> goals, const RefineMemory& memory,
                   CheckpointDirectory* checkpoint, const TakeLevel& take,
                   const MoveVertices& move) {
  Refiner(job, settings, memory, checkpoint, move).run(std::move(whole), goals, take);
}

}  // namespace winnow
