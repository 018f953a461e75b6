#include "run/refinement.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "base/trigonometry.hpp"
#include "run/simplify_options.hpp"
#include "stitch/refine.hpp"

#include <string>
#include <utility>

namespace winnow {

namespace {

CollapseCost collapse_cost(Refine refine) {
  if (refine == Refine::volume) return CollapseCost::volume;
  return refine == Refine::importance ? CollapseCost::importance : CollapseCost::quadric;
}

const char* name_of(StoppedBy reason) {
  if (reason == StoppedBy::error) return "error";
  return reason == StoppedBy::topology ? "topology" : "count";
}

}  // namespace

RefineMemory refine_memory(std::uint64_t left) {
  return {left / 2, left / 8, left / 4, left / 8};
}

ClusteredMesh refined(Job& job, Clustered clustered, const SimplifyOptions& options, bool doubles,
                      CheckpointDirectory* checkpoint, SimplifyReport& report) {
  RefineSettings settings;
  settings.faces = clustered.target;
  settings.attributes = clustered.attributes.size();
  settings.decimation.cost = collapse_cost(cost_of(options));
  settings.decimation.single = !doubles;
  settings.decimation.least_cosine = cosine(options.max_normal_deviation / 180 * pi);
  settings.decimation.keep_borders = options.borders == Borders::keep;
  if (clustered.error > 0) settings.decimation.error = clustered.error;
  const RefineMemory memory = refine_memory(job.budget.left());
  RefinedMesh whole{std::move(clustered.mesh), nullptr};
  whole.state = std::move(whole.mesh.quadrics);
  RefineReport done;
  ClusteredMesh out = refine(job, std::move(whole), settings, memory, done, checkpoint);
  if (out.face_count == 0)
    throw Error(ErrorKind::failed, "no face is left: faces without neighbours go first; choose more faces");
  report.refine.cost = cost_of(options);
  report.refine.tiles = done.tiles;
  report.refine.collapses = done.collapses;
  report.refine.max_error = done.largest_error;
  report.refine.stopped_by = name_of(done.stopped_by);
  if (report.resumed) {
    report.resumed->rounds = done.rounds_before;
    report.resumed->tiles = done.tiles_before;
  }
  if (done.stopped_by == StoppedBy::topology) {
    job.note("no edge can be collapsed any more without changing what the surface is: " +
             grouped(out.face_count) + " faces are left instead of " + grouped(settings.faces));
  }
  return out;
}

}  // namespace winnow
