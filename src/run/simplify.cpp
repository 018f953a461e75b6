// The pipeline: read, cluster, refine, write.
#include <winnow/checkpoint.hpp>
#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "io/arena.hpp"
#include "measure/result_surface.hpp"
#include "mesh/vertex_map.hpp"
#include "options/level_targets.hpp"
#include "run/attributes.hpp"
#include "run/cluster_input.hpp"
#include "run/input.hpp"
#include "run/outputs.hpp"
#include "run/plan.hpp"
#include "run/refinement.hpp"
#include "run/run_checkpoint.hpp"
#include "run/simplify_options.hpp"
#include "run/simplify_source.hpp"
#include "run/write_mesh.hpp"
#include "write/mesh_encoder.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace winnow {

namespace {

// Faces that hardly share an edge: more than this part of so many edges are boundaries.
constexpr double loose_edges = 0.9;
constexpr std::uint64_t enough_edges = 100;
constexpr std::uint64_t most_edges_noted = 3 << 20;  // of the 2^20 faces that are always counted

// What a note of one result of several begins with.
std::string level_named(const Target& target, const SimplifyOptions& options) {
  if (options.coarser.empty()) return "";
  return (target.faces() ? grouped(*target.faces()) + " faces" : text_of(target)) + ": ";
}

// What became of the surface that `report` tells of; notes what is odd about it. `level`: the notes
// begin with it.
ResultSurface check_surface(Job& job, const StoredMesh& mesh, const SimplifyOptions& options,
                            const std::string& level, const SimplifyReport& report) {
  const ResultSurface surface = measure_result(job, mesh, share::left::checking(job.budget.left()));
  // Whatever the budget is, the note is the same.
  const bool of_input =
      report.topology.input.has_value() && report.topology.input->total <= most_edges_noted;
  const SurfaceEdges& edges = of_input ? *report.topology.input : surface.edges;
  if (edges.total >= enough_edges &&
      static_cast<double>(edges.boundary) > loose_edges * static_cast<double>(edges.total)) {
    job.note(level +
             percentage(static_cast<double>(edges.boundary) / static_cast<double>(edges.total)) +
             " of the edges of the " + (of_input ? "input" : "result") +
             " are boundaries, as if its faces did not touch; " +
             (welds(options) ? "a larger distance of `weld`" : "`weld` DISTANCE") +
             " joins vertices that lie near each other");
  }
  note_lost_area(job, level, report.area.input, surface.area);
  return surface;
}

// How the results are written, whatever their size.
struct Style {
  bool normals, doubles, exact;
};

Style style_of(const SimplifyOptions& options, const MeshEncoder& encoder,
               const Clustered& clustered) {
  // Where the input's normals are no attributes of the output, its own stand in for them.
  const bool normals = options.normals || writes_normals(clustered.attributes, encoder,
                                                         clustered.normals && !options.attributes);
  const bool exact = clustered.double_positions;
  return {normals, writes_doubles(options.encoding, exact), exact};
}

// `input`: of a run whose mesh is not in the checkpoint.
SimplifyReport run_pipeline(Job& job, std::optional<Input> input, const Outputs& outputs,
                            const RunRequest& request, RunCheckpoint& checkpoint,
                            const Stopwatch& watch) {
  const SimplifyOptions& options = request.options;
  const bool mapped = !outputs.maps.empty();
  const MeshEncoder& encoder = outputs.meshes.front()->encoder();
  const AttributeRequest wish = wish_for(options, encoder);
  AttributeSelection choice;
  if (input && !wish.none())
    choice = input->probe(options, access_for(options, mapped), wish).facts.choice;
  const auto plan_of = [taken = input ? input->memory() : job.budget.used(), threads = job.threads,
                        needs = needs_of(options, choice)](std::uint64_t total) {
    return MemoryPlan::divide(total, taken, threads, needs);
  };
  const MemoryPlan plan = plan_of(job.budget.total());
  job.budget.expect(0);
  const Reservation fixed = job.budget.reserve(plan.fixed, "working threads");
  Clustered clustered;
  if (input) {
    checkpoint.begun();
    clustered = cluster_input(job, *input, options, wish, mapped, plan, watch);
    if (checkpoint.opened()) clustered.report.resumed.emplace();
    checkpoint.save(job, clustered);
  } else {
    clustered = checkpoint.load(job, plan.cluster.vertices + plan.cluster.result);
    clustered.report.levels.clear();  // of a run that was killed when all were made
    clustered.report.seconds = {};
    clustered.report.seconds.read = watch.seconds();
  }
  SimplifyReport report = std::move(clustered.report);
  const std::unique_ptr<Spool> map_of_input = std::move(clustered.map);
  const std::vector<Attribute> attributes = clustered.attributes;
  const Style style = style_of(options, encoder, clustered);
  const std::vector<Target> targets = targets_of(options);
  const auto write = [&](const StoredMesh& mesh) {
    const Stopwatch writing;
    const std::size_t level = report.levels.size();
    ResultSink& sink = *outputs.meshes[level];
    const ResultSurface surface =
        check_surface(job, mesh, options, level_named(targets[level], options), report);
    report.topology.output = surface.edges;
    report.topology.output_pieces = surface.pieces;
    report.topology.closed = surface.closed;
    report.area.output = surface.area;
    const StoredOutput result(mesh);
    MeshShape shape = shape_of(job, result, sink.encoder(), style.normals, style.doubles,
                               style.exact, "simplified by winnow");
    shape.attributes = attributes;
    shape.closed = report.topology.closed;
    const std::uint64_t written = sink.write(result, shape);
    report.output = {mesh.face_count,
                     mesh.vertices->size(),
                     written,
                     sink.name(),
                     sink.format(),
                     {},
                     sink.encoder().position_error(shape)};
    if (mapped) {
      MapSink& map = *outputs.maps[level];
      report.output.map = map.name();
      if (mesh.map == nullptr) {
        map.write(job, *map_of_input);
      } else {
        const std::uint64_t memory = share::left::map(job.budget.left());
        map.write(job, *composed(job, *map_of_input, *mesh.map, memory));
      }
    }
    report.levels.push_back(report);
    report.seconds.write += writing.seconds();
  };
  if (cost_of(options) == Refine::none) {
    write(clustered.mesh);
  } else {
    refine_to_targets(job, std::move(clustered), options, style.doubles, mapped, plan_of,
                      checkpoint.directory(),
                      [&](const StoredMesh& mesh, const Refinement& refined) {
                        report.refine = refined.refine;
                        report.fit = refined.fit;
                        report.lost = refined.lost;
                        report.missed_by = refined.missed_by;
                        if (report.target_faces) {
                          report.target_faces = refined.wanted;
                          report.target_met = mesh.face_count <= refined.wanted;
                        }
                        if (report.resumed) {
                          report.resumed->rounds += refined.rounds_before;
                          report.resumed->tiles += refined.tiles_before;
                        }
                        write(mesh);
                      });
    report.seconds.refine =
        watch.seconds() - report.seconds.read - report.seconds.cluster - report.seconds.write;
  }
  static_cast<LevelReport&>(report) = report.levels.front();
  if (report.levels.size() == 1) report.levels.clear();

  report.input.names = request.inputs;
  report.error_bound = report.cell_size * std::sqrt(3.0);
  report.spilled_bytes = job.scratch.written();
  report.peak_scratch_bytes = job.scratch.peak();
  // A file that is opened again says the same again.
  for (const std::string& note : job.notes) {
    if (std::find(report.notes.begin(), report.notes.end(), note) == report.notes.end())
      report.notes.push_back(note);
  }
  checkpoint.settled(outputs, report);
  finish(outputs);
  checkpoint.finish(job);

  report.peak_memory_bytes = peak_resident_bytes();
  report.seconds.total = watch.seconds();
  report.seconds.write =
      report.seconds.total - report.seconds.cluster - report.seconds.read - report.seconds.refine;
  return report;
}

SimplifyReport simplify_in_arena(Job& job, const RunRequest& request, RunCheckpoint& checkpoint) {
  const SimplifyOptions& options = request.options;
  const char* way_out = checkpoint.way_out();
  const Stopwatch watch;
  // Before a pipe is waited for; of a file, decompressing may need more, and the message should say
  // it all.
  if (request.inputs.size() == 1 && request.inputs.front() == "-")
    MemoryPlan::divide(job.budget.total(), 0, job.threads, needs_of(options));
  expect_plan(job, options);
  Outputs outputs;
  for (const std::string& name : output_names(request.output, options)) {
    SimplifyOptions own = options;
    // One that a run had named before it was killed is the same to the byte.
    own.force |= checkpoint.is_written(outputs.meshes.size(), name);
    outputs.meshes.push_back(std::make_unique<FileSink>(job, name, own, way_out));
  }
  outputs.maps = open_maps(
      job, options, outputs.meshes,
      [&](std::size_t number, const std::string& name) {
        return checkpoint.holds_map(number, name);
      },
      way_out);
  std::optional<Input> input;
  if (!checkpoint.has_mesh()) input.emplace(job, request.inputs);
  return run_pipeline(job, std::move(input), outputs, request, checkpoint, watch);
}

SimplifyReport simplify_with(Job& job, const RunRequest& request, RunCheckpoint checkpoint) {
  try {
    return in_arena(job, [&] { return simplify_in_arena(job, request, checkpoint); });
  } catch (const Error& error) {
    checkpoint.fail(error);
  }
}

}  // namespace

void expect_plan(Job& job, const SimplifyOptions& options) {
  remove_stale_files(job.scratch.directory(), scratch_prefix);
  // Packing, compressing and decompressing take memory of their own; the rest is divided.
  job.budget.expect(MemoryPlan::smallest_for(job.threads, needs_of(options)));
}

SimplifyReport simplify_input(Job& job, Input input, const Outputs& outputs,
                              const SimplifyOptions& options, const Stopwatch& watch) {
  RunCheckpoint none;
  return run_pipeline(job, std::move(input), outputs, {{}, {}, options}, none, watch);
}

SimplifyReport simplify(Context& context, const std::vector<std::string>& inputs,
                        const std::string& output, const SimplifyOptions& options) {
  check(options);
  Job job(context);
  return simplify_with(job, {inputs, output, options}, {});
}

SimplifyReport simplify(Context& context, const std::string& input, const std::string& output,
                        const SimplifyOptions& options) {
  return simplify(context, std::vector{input}, output, options);
}

SimplifyReport simplify(Context& context, const std::vector<std::string>& inputs,
                        const std::string& output, const SimplifyOptions& options,
                        const Checkpoint& settings) {
  check(options);
  Job job(context, settings.directory);
  const RunRequest request{inputs, output, options};
  return simplify_with(job, request, RunCheckpoint::begin(job, settings, request));
}

SimplifyReport resume(Context& context, const Checkpoint& settings) {
  const Stopwatch watch;
  Job job(context, settings.directory);
  RunCheckpoint checkpoint = RunCheckpoint::open(job, settings);
  const RunRequest request = checkpoint.request(ResumableCall::simplify);
  if (!checkpoint.are_written(output_names(request.output, request.options))) {
    checkpoint.check_inputs();
    return simplify_with(job, request, std::move(checkpoint));
  }
  SimplifyReport report;
  checkpoint.load_report(report);
  report.resumed.emplace().written = true;
  report.input.names = request.inputs;
  checkpoint.finish(job);
  report.peak_memory_bytes = peak_resident_bytes();
  report.seconds.total = watch.seconds();
  return report;
}

}  // namespace winnow
