// The road: read, cluster, refine, write.
#include <winnow/simplify.hpp>

#include "io/arena.hpp"
#include "io/byte_sink.hpp"
#include "run/attributes.hpp"
#include "run/clustering.hpp"
#include "run/plan.hpp"
#include "run/refinement.hpp"
#include "run/simplify_options.hpp"
#include "run/write_mesh.hpp"
#include "write/mesh_encoder.hpp"

#include <cmath>
#include <utility>

namespace winnow {

namespace {

SimplifyReport simplify_in_arena(Job& job, const std::string& input, const std::string& output,
                                 const SimplifyOptions& options) {
  const Stopwatch watch;
  // Before a pipe is waited for; of a file, decompressing may need more, and the message should say it all.
  if (input == "-") MemoryPlan::divide(job.budget.total(), 0, job.threads, needs_of(options));
  const std::unique_ptr<MeshEncoder> encoder = make_encoder(options.to, output);
  remove_stale_files(job.scratch.directory(), scratch_prefix);
  ByteSink sink(job, output, options.force);
  SimplifyReport report;

  // Decompressing takes memory of its own, which shows with the first bytes; the rest is divided.
  job.budget.expect(MemoryPlan::smallest_for(job.threads, needs_of(options)));
  std::unique_ptr<ByteSource> source = open_source(job, input);
  source->peek(1);
  const AttributeWish wish = wish_for(options, *encoder);
  AttributeChoice choice;
  if (!wish.none()) choice = look_at(job, *source, options.from, access_for(options), wish).facts.choice;
  const MemoryPlan plan =
      MemoryPlan::divide(job.budget.total(), job.budget.used(), job.threads, needs_of(options, choice));
  job.budget.expect(0);
  const Reservation fixed = job.budget.reserve(plan.fixed, "working threads");
  const std::unique_ptr<MeshReader> reader =
      open_reader(job, std::move(source), options.from, access_for(options), plan.reader, wish);
  const CarriedAttributes attributes = take_attributes(job, *reader, report);
  Clustering clustering(job, *reader, options, attributes, plan, report);
  const double opened = watch.seconds();
  ClusteredMesh mesh = clustering.run();
  report.seconds.read += opened;
  report.seconds.cluster = watch.seconds() - report.seconds.read;
  if (cost_of(options) != Refine::none) {
    mesh = refined(job, std::move(mesh), options, clustering, !reader->facts().double_positions,
                   attributes.attributes.size(), report);
    report.seconds.refine = watch.seconds() - report.seconds.read - report.seconds.cluster;
  }

  // Where the input's normals are no attributes of the output, its own stand in for them.
  const bool normals = options.normals || (reader->facts().normals && !options.attributes &&
                                           !carries_normals(attributes.attributes));
  const MeshShape shape{
      mesh.vertices->size(),  mesh.face_count,      normals, reader->facts().double_positions,
      "simplified by winnow", attributes.attributes};
  write_mesh(job, mesh, shape, *encoder, sink);
  sink.finish();

  report.input.vertices = reader->facts().vertices.value_or(0);
  report.input.bytes = reader->bytes();
  report.output = {mesh.face_count, mesh.vertices->size(), sink.written()};
  report.cell_size = clustering.cell();
  report.cells = mesh.cells;
  report.turned_faces = mesh.turned;
  report.fused_faces = mesh.fused;
  report.error_bound = clustering.cell() * std::sqrt(3.0);
  report.spilled_bytes = job.scratch.written();
  report.peak_scratch_bytes = job.scratch.peak();
  report.peak_memory_bytes = peak_resident_bytes();
  report.seconds.total = watch.seconds();
  report.seconds.write =
      report.seconds.total - report.seconds.cluster - report.seconds.read - report.seconds.refine;
  report.notes = job.notes;
  return report;
}

}  // namespace

SimplifyReport simplify(Context& context, const std::string& input, const std::string& output,
                        const SimplifyOptions& options) {
  check(options);
  Job job(context);
  return in_arena(job, [&] { return simplify_in_arena(job, input, output, options); });
}

}  // namespace winnow
