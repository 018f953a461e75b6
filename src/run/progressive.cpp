// A mesh as a progressive file: read, weld, refine and record, encode, write.
#include <winnow/error.hpp>
#include <winnow/progressive.hpp>

#include "base/text.hpp"
#include "base/trigonometry.hpp"
#include "io/arena.hpp"
#include "io/byte_sink.hpp"
#include "options/check_ranges.hpp"
#include "progressive/encode_rounds.hpp"
#include "progressive/shares.hpp"
#include "run/attributes.hpp"
#include "run/clustering.hpp"
#include "run/input.hpp"
#include "run/plan.hpp"
#include "run/refinement.hpp"
#include "run/simplify_options.hpp"
#include "run/take_usage.hpp"
#include "stitch/record_rounds.hpp"
#include "write/formats.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace winnow {

namespace {

void check(const ProgressiveOptions& options) {
  check_ranges(progressive_options(), options);
  if (options.refine == Refine::none)
    throw Error(ErrorKind::usage,
                "`refine` takes quadric, volume or importance: a progressive file is made by "
                "collapses");
}

// All faces, of which nothing is clustered.
SimplifyOptions reading_options(const ProgressiveOptions& options) {
  SimplifyOptions all;
  all.target = Target::ratio(1);
  all.detail = std::numeric_limits<double>::infinity();
  all.refine = options.refine;
  all.topology = options.topology;
  all.attributes = options.attributes;
  all.strict = options.strict;
  all.from = options.from;
  return all;
}

RefineSettings settings_for(const ProgressiveOptions& options, const SimplifyOptions& reading,
                            const Clustered& clustered) {
  RefineSettings settings;
  settings.faces = options.base;
  settings.attributes = clustered.attributes;
  settings.decimation.cost = options.refine;
  settings.decimation.single = !clustered.double_positions;
  settings.decimation.rounding = clustered.mesh.rounding;
  settings.decimation.least_cosine = cosine(reading.max_normal_deviation / 180 * pi);
  settings.decimation.free_topology = options.topology == Topology::free;
  return settings;
}

Box box_of(Job& job, const StoredMesh& mesh) {
  Box box;
  SpoolCursor<IndexedVertex> vertices(job, mesh.vertices->records());
  for (IndexedVertex vertex; vertices.next(vertex);) box.add(vertex.position);
  return box;
}

void note_base(Job& job, std::uint64_t faces, const ProgressiveOptions& options) {
  if (faces <= options.base) return;
  job.note("the coarsest mesh has " + grouped(faces) + " faces instead of " +
           grouped(options.base) + ": fewer would change the topology or destroy the shape" +
           (options.topology == Topology::free ? "" : "; `topology` free goes further"));
}

void write_file(Job& job, const ProgressiveHeader& header, const Spool& chunks, ByteSink& sink) {
  job.progress.begin("write", header.all().bytes, "bytes");
  sink.write(encode_header(header));
  chunks.for_each_part(1, [&](std::span<const std::byte> part) {
    job.progress.check_cancelled();
    sink.write(part);
    job.progress.advance(part.size());
  });
  sink.finish();
}

// What refining the clustered mesh gives, in the file. Fills the report.
void make_file(Job& job, Clustered clustered, const ProgressiveOptions& options,
               const SimplifyOptions& reading, ByteSink& sink, ProgressiveReport& report,
               const Stopwatch& watch) {
  ProgressiveHeader header;
  header.box = box_of(job, clustered.mesh);
  header.form = options.bits
                    ? PositionForm::lattice(clustered.double_positions, *options.bits, header.box)
                    : PositionForm::exact(clustered.double_positions);
  header.cost = options.refine;
  header.normals = clustered.normals;
  header.attributes = clustered.attributes;
  const VertexWords words(header.form, header.attributes);
  const RefineSettings settings = settings_for(options, reading, clustered);
  const std::uint64_t vertices = clustered.mesh.vertices->size();
  const std::uint64_t left = job.budget.left();
  const RecordedMesh recorded = record_rounds(job, std::move(clustered.mesh), settings, words,
                                              refine_memory(share::progressive::refining(left)),
                                              share::progressive::records(left));
  note_base(job, recorded.base.face_count, options);
  report.seconds.refine = watch.seconds() - report.seconds.read;
  const EncodedRounds encoded =
      encode_rounds(job, recorded.rounds, recorded.base, recorded.round_count > 0, vertices, words,
                    share::progressive::encoding(left));
  header.base_chunks = encoded.base_chunks;
  header.chunks = encoded.chunks;
  write_file(job, header, encoded.bytes, sink);

  const ProgressiveHeader::Counts all = header.all();
  report.output.faces = all.faces;
  report.output.vertices = all.vertices;
  report.output.bytes = all.bytes;
  report.output.base_faces = header.base().faces;
  report.output.base_vertices = header.base().vertices;
  report.output.chunks = header.chunks.size();
  report.output.position_error = header.form.step / 2 * std::sqrt(3.0);
  report.rounds = recorded.round_count;
  report.collapses = recorded.collapses;
}

ProgressiveReport progressive_in_arena(Job& job, const std::vector<std::string>& inputs,
                                       const std::string& output,
                                       const ProgressiveOptions& options) {
  const Stopwatch watch;
  const SimplifyOptions reading = reading_options(options);
  remove_stale_files(job.scratch.directory(), scratch_prefix);
  job.budget.expect(MemoryPlan::smallest_for(job.threads, needs_of(reading)));
  // Before a pipe is waited for.
  if (inputs.size() == 1 && inputs.front() == "-")
    MemoryPlan::divide(job.budget.total(), 0, job.threads, needs_of(reading));
  ByteSink sink(job, output, options.force);
  sink.refuse_terminal();
  // A PLY holds whatever vertices carry.
  const std::unique_ptr<MeshEncoder> encoder = make_encoder(Format::ply, {});
  Input input(job, inputs);
  const AttributeRequest wish = wish_for(reading, *encoder);
  AttributeSelection choice;
  if (!wish.none()) choice = input.probe(reading, Access::repeatedly, wish).facts.choice;
  const MemoryPlan plan = MemoryPlan::divide(job.budget.total(), input.memory(), job.threads,
                                             needs_of(reading, choice));
  job.budget.expect(0);
  const Reservation fixed = job.budget.reserve(plan.fixed, "working threads");
  ReaderMemory memory = plan.reader;
  memory.any_order = !options.strict;
  Clustered clustered;
  {
    const std::unique_ptr<MeshReader> reader =
        input.reader(reading, Access::repeatedly, wish, memory);
    TakenAttributes attributes = take_attributes(job, *reader);
    clustered = Clustering(job, *reader, reading, std::move(attributes), plan, false).run();
  }
  ProgressiveReport report;
  const SimplifyReport& read = clustered.report;
  report.input = {inputs,           read.input.format,   read.input.faces, read.input.vertices,
                  read.input.bytes, read.input.bad_faces};
  report.attributes = read.attributes;
  report.cost = options.refine;
  report.seconds.read = watch.seconds();
  report.output.name = output;
  make_file(job, std::move(clustered), options, reading, sink, report, watch);

  take_usage(job, watch, report);
  return report;
}

}  // namespace

ProgressiveReport progressive(Context& context, const std::vector<std::string>& inputs,
                              const std::string& output, const ProgressiveOptions& options) {
  check(options);
  Job job(context);
  return in_arena(job, [&] { return progressive_in_arena(job, inputs, output, options); });
}

}  // namespace winnow
