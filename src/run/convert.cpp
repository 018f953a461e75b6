// The short pipeline: read, weld what has no vertices, write.
#include <winnow/convert.hpp>
#include <winnow/error.hpp>

#include "cluster/welder.hpp"
#include "io/arena.hpp"
#include "io/byte_sink.hpp"
#include "measure/result_surface.hpp"
#include "read/for_each_batch.hpp"
#include "read/good_faces.hpp"
#include "run/attributes.hpp"
#include "run/input.hpp"
#include "run/plain_mesh.hpp"
#include "run/plan.hpp"
#include "run/take_usage.hpp"
#include "run/write_blocks.hpp"
#include "run/write_mesh.hpp"
#include "write/formats.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace winnow {

namespace {

// Nothing is clustered, so the shares of that go to the mesh.
StoredMesh mesh_of(Job& job, MeshReader& reader, const MemoryPlan& plan, ClusterCounts& counts) {
  if (reader.facts().vertices) {
    const std::uint64_t carried = reader.facts().choice.carried.size() * sizeof(double);
    const Reservation under_way = job.budget.reserve(
        batches_in_flight(job.threads) * plan.reader.batch_faces * carried, "what vertices carry");
    const std::uint64_t left = plan.cluster.table - std::min(under_way.bytes(), plan.cluster.table);
    return plain_mesh(job, reader, {left, plan.cluster.result}, counts);
  }
  WeldResult welded =
      weld(job, reader, {}, {plan.cluster.table, plan.cluster.vertices, plan.cluster.result, {}},
           reader.facts().faces.value_or(0));
  counts = welded.counts;
  return std::move(welded.mesh);
}

// Whatever the output's format can hold.
AttributeRequest wish_for(const MeshEncoder& encoder) {
  AttributeRequest wish;
  wish.names.reset();
  wish.averaged = false;
  wish.refusal = [&encoder](const Attribute& attribute, std::span<const Attribute> wanted) {
    return encoder.attribute_refusal(attribute, wanted);
  };
  return wish;
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
  const Reservation packing = reserve_block(job, *encoder, true);
  ByteSink sink(job, output, options.force);
  if (!writes_text(options.to, output, options.encoding)) sink.refuse_terminal();
  std::unique_ptr<ByteSource> source = open_source(job, input);
  source->peek(1);
  const AttributeRequest wish = wish_for(*encoder);
  const MemoryPlan plan =
      MemoryPlan::divide(job.budget.total(), job.budget.used(), job.threads, nothing);
  job.budget.expect(0);
  const Reservation fixed = job.budget.reserve(plan.fixed, "working threads");
  const std::unique_ptr<MeshReader> reader =
      open_reader(job, std::move(source), options.from, Access::positions_first, plan.reader, wish);
  const InputFacts& facts = reader->facts();
  const bool doubles = writes_doubles(options.encoding, facts.double_positions);
  // Refuses at once what the format cannot count.
  (void)encoder->header({.vertices = facts.vertices.value_or(0), .faces = facts.faces.value_or(0)});
  note_dropped(job, facts.choice);

  ConvertReport report;
  ClusterCounts counts;
  // A PLY has them as they are.
  std::vector<Attribute> attributes = facts.choice.carried;
  if (!encoder->keeps_numbers() && !attributes.empty())
    settle_colors(job, attributes, reader->attribute_ranges());
  const StoredMesh mesh = mesh_of(job, *reader, plan, counts);
  if (options.strict && counts.first_bad.face != UINT64_MAX)
    refuse_bad_face(reader->name(), counts.first_bad);
  if (mesh.face_count == 0) refuse_without_faces(*reader, "written");
  reader->release_memory();
  report.seconds.read = watch.seconds();
  const bool normals = carries_normals(attributes) && encoder->normals_apart();
  MeshShape shape = shape_of(job, StoredOutput(mesh), *encoder, normals, doubles,
                             facts.double_positions, "converted by winnow");
  shape.attributes = attributes;
  shape.closed = encoder->needs_survey() && is_closed(job, mesh);
  shape.as_stored = true;
  write_mesh(job, StoredOutput(mesh), shape, *encoder, sink);
  sink.finish();

  report.input = {{input},         facts.format, counts.faces, facts.vertices.value_or(0),
                  reader->bytes(), counts.bad};
  report.output = {output,          format_written(options.to, output, options.encoding),
                   mesh.face_count, mesh.vertices->size(),
                   sink.written(),  encoder->position_error(shape)};
  report.attributes = {descriptions(facts.choice), facts.choice.dropped};
  report.welded = !facts.vertices;
  report.doubled_faces = counts.faces - counts.bad.total() - mesh.face_count;
  take_usage(job, watch, report);
  return report;
}

}  // namespace

ConvertReport convert(Context& context, const std::string& input, const std::string& output,
                      const ConvertOptions& options) {
  Job job(context);
  return in_arena(job, [&] { return convert_in_arena(job, input, output, options); });
}

}  // namespace winnow
