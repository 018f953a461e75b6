// A mesh as a progressive file: read, weld, refine and record, encode, write.
#include <winnow/checkpoint.hpp>
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
#include "run/cluster_input.hpp"
#include "run/input.hpp"
#include "run/plan.hpp"
#include "run/refinement.hpp"
#include "run/run_checkpoint.hpp"
#include "run/simplify_options.hpp"
#include "run/take_usage.hpp"
#include "stitch/record_rounds.hpp"
#include "write/coarse_floats.hpp"
#include "write/formats.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace winnow {

namespace {

void check(const ProgressiveOptions& options, const std::string& output) {
  check_ranges(progressive_options(), options);
  check_progressive_name(output);
  if (options.refine == Refine::none)
    throw Error(ErrorKind::usage,
                "`refine` takes quadric, volume or importance: a progressive file is made by "
                "collapses");
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
  settings.decimation.keep_boundaries = options.boundary == Boundary::keep;
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
  const bool free = options.topology == Topology::free, kept = options.boundary == Boundary::keep;
  job.note("the coarsest mesh has " + grouped(faces) + " faces instead of " +
           grouped(options.base) + ": fewer would change the " +
           (kept ? "boundary or the topology" : "topology") + " or destroy the shape" +
           (free ? "" : "; `topology` free goes further") +
           (kept ? "; `boundary` weigh goes further" : ""));
}

void write_file(Job& job, const ProgressiveHeader& header, const Spool& chunks, ByteSink& sink) {
  job.progress.begin("write", header.all().bytes, "bytes");
  sink.write(encode_header(header));
  chunks.for_each_part(1, [&](std::span<const std::byte> part) {
    job.progress.check_cancelled();
    sink.write(part);
    job.progress.advance(part.size());
  });
  sink.flush_and_sync();
}

// What the whole mesh is like: no round leaves that to be seen.
struct WholeMesh {
  Box box;
  std::uint64_t vertices = 0;
};

WholeMesh whole_of(Job& job, const StoredMesh& mesh, CheckpointDirectory* checkpoint) {
  constexpr const char* count = "whole.vertices";
  const auto key = [](const char* corner, std::size_t axis) {
    return std::string("whole.").append(corner).append(1, static_cast<char>('x' + axis));
  };
  WholeMesh whole;
  if (checkpoint != nullptr && checkpoint->manifest().has(count)) {
    const Manifest& manifest = checkpoint->manifest();
    whole.vertices = manifest.number(count);
    whole.box.empty = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      whole.box.low[axis] = manifest.real(key("low.", axis));
      whole.box.high[axis] = manifest.real(key("high.", axis));
    }
    return whole;
  }
  whole = {box_of(job, mesh), mesh.vertices->size()};
  if (checkpoint == nullptr) return whole;
  // On the disk with the first round.
  Manifest& manifest = checkpoint->manifest();
  manifest.set(count, whole.vertices);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    manifest.set(key("low.", axis), whole.box.low[axis]);
    manifest.set(key("high.", axis), whole.box.high[axis]);
  }
  return whole;
}

// What the file itself tells.
void tell_of(const ProgressiveHeader& header, ProgressiveReport& report) {
  const ProgressiveHeader::Counts all = header.all();
  report.output.faces = all.faces;
  report.output.vertices = all.vertices;
  report.output.bytes = all.bytes;
  report.output.base_faces = header.base().faces;
  report.output.base_vertices = header.base().vertices;
  report.output.chunks = header.chunks.size();
  report.output.position_error = header.position_error();
  report.cost = header.cost;
}

// What refining the clustered mesh gives, in the file. Fills the report.
void make_file(Job& job, Clustered clustered, const RunRequest& request, ByteSink& sink,
               RunCheckpoint& checkpoint, ProgressiveReport& report, const Stopwatch& watch) {
  const ProgressiveOptions& options = *request.progressive;
  const WholeMesh whole = whole_of(job, clustered.mesh, checkpoint.directory());
  ProgressiveHeader header;
  header.box = whole.box;
  header.form = options.bits
                    ? PositionForm::lattice(clustered.double_positions, *options.bits, header.box)
                    : PositionForm::exact(clustered.double_positions);
  header.cost = options.refine;
  header.normals = clustered.normals;
  header.attributes = clustered.attributes;
  const VertexWords words(header.form, header.attributes);
  const RefineSettings settings = settings_for(options, request.options, clustered);
  const std::uint64_t left = job.budget.left();
  const RecordedMesh recorded =
      record_rounds(job, std::move(clustered.mesh), settings, words,
                    refine_memory(share::progressive::refining(left)),
                    share::progressive::records(left), checkpoint.directory());
  note_base(job, recorded.base.face_count, options);
  report.seconds.refine = watch.seconds() - report.seconds.read;
  const EncodedRounds encoded =
      encode_rounds(job, recorded.rounds, recorded.base, recorded.round_count > 0, whole.vertices,
                    words, share::progressive::encoding(left));
  header.base_chunks = encoded.base_chunks;
  header.chunks = encoded.chunks;
  for (ChunkEntry& chunk : header.chunks) chunk.error += header.position_error();
  write_file(job, header, encoded.bytes, sink);
  tell_of(header, report);
  note_coarse_steps(job, header.box, report.output.faces, report.output.position_error);
  report.rounds = recorded.round_count;
  report.collapses = recorded.collapses;
  if (report.resumed) {
    report.resumed->rounds = recorded.rounds_before;
    report.resumed->tiles = recorded.tiles_before;
  }
}

void tell_of(const SimplifyReport& read, const RunRequest& request, ProgressiveReport& report) {
  report.input = {request.inputs,          read.input.format, read.input.faces,
                  read.input.vertices,     read.input.bytes,  read.input.bad_faces,
                  read.input.cropped_faces};
  report.weld = read.weld;
  report.attributes = read.attributes;
  report.output.name = request.output;
  report.resumed = read.resumed;
}

// `source`: of the input where it is open already, else null.
ProgressiveReport progressive_in_arena(Job& job, const RunRequest& request,
                                       RunCheckpoint& checkpoint,
                                       std::unique_ptr<ByteSource> source) {
  const Stopwatch watch;
  const SimplifyOptions& reading = request.options;
  remove_stale_files(job.scratch.directory(), scratch_prefix);
  job.budget.expect(MemoryPlan::smallest_for(job.threads, needs_of(reading)));
  // Before a pipe is waited for.
  if (request.inputs.size() == 1 && request.inputs.front() == "-")
    MemoryPlan::divide(job.budget.total(), 0, job.threads, needs_of(reading));
  ByteSink sink(job, request.output,
                request.progressive->force || checkpoint.is_written(0, request.output),
                checkpoint.way_out());
  sink.refuse_terminal();
  // A PLY holds whatever vertices carry.
  const std::unique_ptr<MeshEncoder> encoder = make_encoder(Format::ply, {});
  std::optional<Input> input;
  if (source != nullptr) {
    input.emplace(job, std::move(source));
  } else if (!checkpoint.has_mesh()) {
    input.emplace(job, request.inputs);
  }
  const AttributeRequest wish = wish_for(reading, *encoder);
  AttributeSelection choice;
  if (input && !wish.none()) choice = input->probe(reading, Access::repeatedly, wish).facts.choice;
  const MemoryPlan plan =
      MemoryPlan::divide(job.budget.total(), input ? input->memory() : job.budget.used(),
                         job.threads, needs_of(reading, choice));
  job.budget.expect(0);
  const Reservation fixed = job.budget.reserve(plan.fixed, "working threads");
  Clustered clustered;
  if (input) {
    checkpoint.begun();
    clustered = cluster_input(job, *input, reading, wish, false, plan, watch);
    if (checkpoint.opened()) clustered.report.resumed.emplace();
    checkpoint.save(job, clustered);
  } else {
    clustered = checkpoint.load(job, plan.cluster.vertices + plan.cluster.result);
  }
  ProgressiveReport report;
  SimplifyReport read = std::move(clustered.report);
  tell_of(read, request, report);
  report.seconds.read = watch.seconds();
  make_file(job, std::move(clustered), request, sink, checkpoint, report, watch);
  read.notes = job.notes;
  checkpoint.settled(std::vector{sink.identity()}, read);
  sink.finish();
  checkpoint.finish(job);
  take_usage(job, watch, report);
  return report;
}

ProgressiveReport progressive_with(Job& job, const RunRequest& request, RunCheckpoint checkpoint) {
  try {
    return in_arena(job, [&] { return progressive_in_arena(job, request, checkpoint, nullptr); });
  } catch (const Error& error) {
    checkpoint.fail(error);
  }
}

void copy(Job& job, ByteSource& source, const std::string& output, bool force) {
  constexpr std::size_t at_once = std::size_t{1} << 20;
  ByteSink sink(job, output, force);
  job.progress.begin("write", source.size().value_or(0), "bytes");
  for (;;) {
    job.progress.check_cancelled();
    const Block block = source.take(at_once);
    if (block.bytes.empty()) break;
    sink.write(block.bytes);
    block.check_intact(source.name());
    job.progress.advance(block.bytes.size());
  }
  sink.flush_and_sync();
  sink.finish();
}

// Of a run that had written its file, and was killed before it had cleared its checkpoint away.
ProgressiveReport written_before(Job& job, const RunRequest& request, const SimplifyReport& read) {
  const Stopwatch watch;
  ProgressiveReport report;
  tell_of(read, request, report);
  report.resumed.emplace().written = true;
  if (request.output != "-") tell_of(read_header(job, *open_source(job, request.output)), report);
  job.notes = read.notes;
  take_usage(job, watch, report);
  return report;
}

}  // namespace

ProgressiveReport progressive(Context& context, const std::vector<std::string>& inputs,
                              const std::string& output, const ProgressiveOptions& options) {
  check(options, output);
  Job job(context);
  return progressive_with(job, {inputs, output, reading_options(options), options}, {});
}

void copy_or_make_progressive(Context& context, const std::string& input, const std::string& output,
                              const ProgressiveOptions& options) {
  check(options, output);
  Job job(context);
  in_arena(job, [&] {
    std::unique_ptr<ByteSource> source = open_source(job, input);
    if (begins_progressive(*source)) return copy(job, *source, output, options.force);
    const RunRequest request{{input}, output, reading_options(options), options};
    RunCheckpoint none;
    progressive_in_arena(job, request, none, std::move(source));
  });
}

ProgressiveReport progressive(Context& context, const std::vector<std::string>& inputs,
                              const std::string& output, const ProgressiveOptions& options,
                              const Checkpoint& settings) {
  check(options, output);
  Job job(context, settings.directory);
  const RunRequest request{inputs, output, reading_options(options), options};
  return progressive_with(job, request, RunCheckpoint::begin(job, settings, request));
}

ProgressiveReport resume_progressive(Context& context, const Checkpoint& settings) {
  Job job(context, settings.directory);
  RunCheckpoint checkpoint = RunCheckpoint::open(job, settings);
  const RunRequest request = checkpoint.request(ResumableCall::progressive);
  if (!checkpoint.are_written({request.output})) {
    checkpoint.check_inputs();
    return progressive_with(job, request, std::move(checkpoint));
  }
  SimplifyReport read;
  checkpoint.load_report(read);
  ProgressiveReport report = written_before(job, request, read);
  checkpoint.finish(job);
  return report;
}

}  // namespace winnow
