// The short road: read, weld what has no vertices, write.
#include <winnow/convert.hpp>
#include <winnow/error.hpp>

#include "cluster/welder.hpp"
#include "io/arena.hpp"
#include "io/byte_sink.hpp"
#include "read/good_faces.hpp"
#include "run/plain_mesh.hpp"
#include "run/plan.hpp"
#include "run/write_blocks.hpp"
#include "run/write_mesh.hpp"
#include "write/mesh_encoder.hpp"

#include <memory>
#include <utility>

namespace winnow {

namespace {

// Nothing is clustered, so the shares of that go to the mesh.
ClusteredMesh mesh_of(Job& job, MeshReader& reader, const MemoryPlan& plan, ClusterCounts& counts) {
  if (reader.facts().vertices)
    return plain_mesh(job, reader, {plan.cluster.table, plan.cluster.result}, counts);
  return weld(job, reader, {}, {plan.cluster.table, plan.cluster.vertices, plan.cluster.result, {}, 0},
              counts);
}

void note_what_is_left(Job& job, const InputFacts& facts) {
  if (facts.attributes.empty()) return;
  std::string line = "positions alone are carried, not ";
  for (const std::string& attribute : facts.attributes)
    line += (&attribute == facts.attributes.data() ? "" : "; ") + attribute;
  job.note(line);
}

ConvertReport convert_in_arena(Job& job, const std::string& input, const std::string& output,
                               const ConvertOptions& options) {
  const Stopwatch watch;
  const CellNeeds nothing;
  // Before a pipe is waited for.
  if (input == "-") MemoryPlan::divide(job.budget.total(), 0, job.threads, nothing);
  const std::unique_ptr<MeshEncoder> encoder = make_encoder(options.to, output, options.encoding);
  remove_stale_files(job.scratch.directory(), scratch_prefix);
  job.budget.expect(MemoryPlan::smallest_for(job.threads, nothing));
  const Reservation packing = reserve_block(job, *encoder);
  ByteSink sink(job, output, options.force);
  std::unique_ptr<ByteSource> source = open_source(job, input);
  source->peek(1);
  const MemoryPlan plan = MemoryPlan::divide(job.budget.total(), job.budget.used(), job.threads, nothing);
  job.budget.expect(0);
  const Reservation fixed = job.budget.reserve(plan.fixed, "working threads");
  const std::unique_ptr<MeshReader> reader =
      open_reader(job, std::move(source), options.from, Access::positions_first, plan.reader);
  const InputFacts& facts = reader->facts();
  const bool doubles = writes_doubles(options.encoding, facts.double_positions);
  // Refuses at once what the format cannot count.
  (void)encoder->header({.vertices = facts.vertices.value_or(0), .faces = facts.faces.value_or(0)});
  note_what_is_left(job, facts);

  ConvertReport report;
  ClusterCounts counts;
  const ClusteredMesh mesh = mesh_of(job, *reader, plan, counts);
  if (options.strict && counts.first_bad.face != UINT64_MAX)
    refuse_bad_face(reader->name(), counts.first_bad);
  if (mesh.face_count == 0)
    throw Error(ErrorKind::bad_input, "'" + reader->name() + "' has no face that could be written");
  reader->rest();
  report.seconds.read = watch.seconds();
  write_mesh(job, mesh,
             shape_of(job, mesh, *encoder, false, doubles, facts.double_positions, "converted by winnow"),
             *encoder, sink);
  sink.finish();

  report.input = {facts.format, counts.faces, facts.vertices.value_or(0), reader->bytes(), counts.bad};
  report.output = {mesh.face_count, mesh.vertices->size(), sink.written()};
  report.welded = !facts.vertices;
  report.doubled_faces = counts.faces - counts.bad.total() - mesh.face_count;
  report.spilled_bytes = job.scratch.written();
  report.peak_scratch_bytes = job.scratch.peak();
  report.peak_memory_bytes = peak_resident_bytes();
  report.seconds.total = watch.seconds();
  report.seconds.write = report.seconds.total - report.seconds.read;
  report.notes = job.notes;
  return report;
}

}  // namespace

ConvertReport convert(Context& context, const std::string& input, const std::string& output,
                      const ConvertOptions& options) {
  Job job(context);
  return in_arena(job, [&] { return convert_in_arena(job, input, output, options); });
}

}  // namespace winnow
