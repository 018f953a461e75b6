#include "run/refinement.hpp"

#include <winnow/error.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "base/trigonometry.hpp"
#include "fit/fit.hpp"
#include "run/simplify_options.hpp"
#include "stitch/collapse_log.hpp"
#include "stitch/refine.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace winnow {

namespace {

const char* sentence_of(StoppedBy reason, bool free) {
  switch (reason) {
    case StoppedBy::boundaries:
      return "`boundary` keep keeps every boundary vertex; `boundary` weigh lets them go";
    case StoppedBy::hubs:
      return "vertices with very many faces stay, and so do faces between two of them";
    case StoppedBy::pieces:
      return "`keep_pieces` keeps every piece of the surface; without it the smallest go";
    case StoppedBy::topology:
    case StoppedBy::error:
    case StoppedBy::count:
      break;
  }
  return free ? "no edge is left that could be collapsed"
              : "fewer would change the topology or destroy the shape; `topology` free closes "
                "handles and holes, and meets the count";
}

// Notes why more faces are left than were wanted; returns the reasons.
std::vector<StoppedBy> tell_reasons(Job& job, const RefineReport& done, std::uint64_t left,
                                    std::uint64_t wanted, bool free) {
  std::vector<StoppedBy> reasons = done.blocked.reasons();
  for (const StoppedBy reason : reasons) {
    const std::string sentence = sentence_of(reason, free);
    job.note(reason == reasons.front()
                 ? grouped(left) + " faces are left instead of " + grouped(wanted) + ": " + sentence
                 : "besides, " + sentence);
  }
  return reasons;
}

// What a run holds at the most beside the tile that it works on, under a budget of any size.
class HeldBesideTile {
 public:
  HeldBesideTile(const Job& job, const StoredMesh& whole, const Samples& samples,
                 const RefineSettings& settings, PlanOf plan)
      : plan_(std::move(plan)), total_(job.budget.total()), fixed_(job.budget.used()) {
    const std::uint64_t vertices = whole.vertices->size();
    const std::uint64_t faces = whole.face_count;
    for (const Spool* spool : whole.spools()) add(spool);
    add(samples.points.get());
    if (std::max(vertices, faces) <= settings.tile_faces) return;
    // A face comes to two other tiles at the most, and a collapse takes away one face at the least.
    incoming_ = 2 * faces * sizeof(FaceVertices);
    log_ = faces * CollapseLog::entry_size;
    for (const Spool* spool : whole.spools()) later_mesh_ += spool == nullptr ? 0 : spool->size();
    // A later round has its borders elsewhere: its largest tile may be larger by so much.
    other_tile_ = tile_memory(settings, settings.tile_faces, settings.tile_faces);
  }

  std::uint64_t operator()(std::uint64_t total) const {
    const std::uint64_t fixed = fixed_ + plan_(total).fixed - plan_(total_).fixed;
    const double growth = static_cast<double>(total - fixed) / static_cast<double>(total_ - fixed_);
    std::uint64_t mesh = 0;
    for (const Part& part : held_) {
      const auto limit = static_cast<std::uint64_t>(growth * static_cast<double>(part.limit));
      if (part.size <= limit) mesh += std::min(limit, reserved_for(part.size));
    }
    const RefineMemory parts = refine_memory(total - fixed - mesh);
    // The mesh stays, for unfolding; beside it there is one that goes into a round, and one that
    // comes out.
    return fixed + mesh + 2 * std::min(parts.mesh, reserved_for(later_mesh_)) +
           std::min(parts.lists / 2, reserved_for(incoming_)) +
           std::min(parts.logs, reserved_for(log_)) + other_tile_;
  }

 private:
  struct Part {
    std::uint64_t size, limit;
  };

  void add(const Spool* spool) {
    if (spool == nullptr) return;
    held_.push_back({spool->size(), spool->memory_limit() + mebibyte});  // limits are rounded down
    if (spool->in_memory()) fixed_ -= spool->size();
  }

  // Spools grow by an eighth more than they are asked to.
  static std::uint64_t reserved_for(std::uint64_t bytes) { return bytes + bytes / 8; }

  PlanOf plan_;
  std::uint64_t total_;
  std::uint64_t fixed_;     // all but the mesh
  std::vector<Part> held_;  // what stays in memory while there is room
  std::uint64_t incoming_ = 0, log_ = 0, later_mesh_ = 0, other_tile_ = 0;  // of several tiles
};

}  // namespace

RefineMemory refine_memory(std::uint64_t left) {
  return {share::refine::tiles(left), share::refine::logs(left), share::refine::mesh(left),
          share::refine::lists(left)};
}

namespace {

// Of the level that was done.
Refinement refinement_of(Job& job, const StoredMesh& mesh, const RefineReport& done,
                         const LevelGoal& goal, const SimplifyOptions& options) {
  if (mesh.face_count == 0)
    throw Error(ErrorKind::failed,
                "no face is left: faces without neighbours go first; choose more faces");
  Refinement out;
  out.refine.cost = cost_of(options);
  out.refine.tiles = done.tiles;
  out.refine.collapses = done.collapses;
  out.refine.max_error = done.largest_error;
  out.refine.stopped_by = done.stopped_by;
  out.lost = {done.changes.pieces, done.changes.area, done.changes.handles, done.changes.holes};
  out.wanted = goal.faces;
  out.rounds_before = done.rounds_before;
  out.tiles_before = done.tiles_before;
  if (done.joined > 0)
    job.note("no edge could be collapsed any more, so " + grouped(done.joined) +
             " vertices were joined with others near them");
  if (done.stopped_by != StoppedBy::count && done.stopped_by != StoppedBy::error)
    out.missed_by =
        tell_reasons(job, done, mesh.face_count, goal.faces, options.topology == Topology::free);
  return out;
}

}  // namespace

void expect_beside_tile(Job& job, const StoredMesh& whole, const Samples& samples,
                        const RefineSettings& settings, const PlanOf& plan) {
  job.budget.expect_held(HeldBesideTile(job, whole, samples, settings, plan));
}

void refine_to_targets(Job& job, Clustered clustered, const SimplifyOptions& options, bool doubles,
                       bool map, const PlanOf& plan, CheckpointDirectory* checkpoint,
                       const std::function<void(const StoredMesh&, const Refinement&)>& take) {
  const std::vector<LevelGoal> goals = std::move(clustered.goals);
  RefineSettings settings;
  settings.map = map;
  settings.attributes = clustered.attributes;
  settings.decimation.cost = cost_of(options);
  settings.decimation.single = !doubles;
  settings.decimation.rounding = clustered.mesh.rounding;
  settings.decimation.least_cosine = cosine(options.max_normal_deviation / 180 * pi);
  settings.decimation.keep_boundaries = options.boundary == Boundary::keep;
  settings.decimation.keep_pieces = options.keep_pieces;
  settings.decimation.free_topology = options.topology == Topology::free;
  if (goals.front().error > 0) settings.decimation.error = goals.front().error;
  const RefineMemory memory = refine_memory(job.budget.left());
  StoredMesh whole = std::move(clustered.mesh);
  const Samples samples = std::move(clustered.samples);
  expect_beside_tile(job, whole, samples, settings, plan);
  std::size_t level = 0;
  FitReport fitted;
  MoveVertices move;
  if (samples.area > 0) {
    move = [&](StoredMesh& mesh, const ReferenceMesh& reference) {
      return fit(job, mesh, samples, {fit_passes(options), false}, reference, settings, memory,
                 fitted);
    };
  }
  refine_levels(
      job, std::move(whole), settings, goals, memory, checkpoint,
      [&](const StoredMesh& mesh, const RefineReport& done) {
        Refinement refined = refinement_of(job, mesh, done, goals[level++], options);
        refined.fit = {fitted.passes, fitted.samples, fitted.moved, fitted.rms_before,
                       fitted.rms_after};
        take(mesh, refined);
      },
      move);
  job.budget.expect_held({});
}

}  // namespace winnow
