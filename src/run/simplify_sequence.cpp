// The pipeline of a sequence: read all frames, refine them as one mesh, write each.
#include <winnow/checkpoint.hpp>
#include <winnow/error.hpp>
#include <winnow/options.hpp>
#include <winnow/sequence.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "base/trigonometry.hpp"
#include "fit/fit.hpp"
#include "io/arena.hpp"
#include "io/spool_records.hpp"
#include "measure/result_surface.hpp"
#include "options/check_ranges.hpp"
#include "read/morph_frames.hpp"
#include "run/attributes.hpp"
#include "run/frame_output.hpp"
#include "run/plan.hpp"
#include "run/read_sequence.hpp"
#include "run/refinement.hpp"
#include "run/run_checkpoint.hpp"
#include "run/sequence_checkpoint.hpp"
#include "run/take_usage.hpp"
#include "run/write_mesh.hpp"
#include "run/written_frames.hpp"
#include "sequence/frame_names.hpp"
#include "sequence/result_frames.hpp"
#include "stitch/refine.hpp"
#include "stitch/unfolded_mesh.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace winnow {

namespace {

void check(const SequenceOptions& options) {
  if (!options.target.of_count())
    throw Error(ErrorKind::usage,
                "say how many faces each frame shall have with `faces` or `ratio`");
  check_ranges(sequence_options(), options);
}

// Whatever has a meaningful mean and the output can hold.
AttributeRequest wish_of(const SequenceOptions& options, const MeshEncoder& encoder) {
  SimplifyOptions own;
  own.normals = options.normals;
  return wish_for(own, encoder);
}

// Fewer where there are many frames, so that a tile takes about the same memory. With 64 frames or
// fewer it has the 2^15 faces and more that its borders hardly show in.
std::uint64_t tile_faces_for(std::size_t frames) {
  return std::clamp<std::uint64_t>((std::uint64_t{1} << 21) / std::bit_ceil(frames),
                                   std::uint64_t{1} << 11, std::uint64_t{1} << 16);
}

RefineSettings settings_for(const SequenceOptions& options, const SequenceMesh& sequence,
                            std::uint64_t faces, bool doubles) {
  RefineSettings settings;
  settings.faces = faces;
  settings.tile_faces = tile_faces_for(sequence.frames);
  settings.decimation.single = !doubles;
  settings.decimation.least_cosine = cosine(options.max_normal_deviation / 180 * pi);
  settings.decimation.sequence = {sequence.frames, options.deformation_weight,
                                  options.feature_weight,
                                  options.quadrics == Quadrics::accumulated};
  for (std::size_t t = 0; t < sequence.frames; ++t)
    settings.attributes.insert(settings.attributes.end(), sequence.attributes.begin(),
                               sequence.attributes.end());
  return settings;
}

// What is done to each frame by itself.
class FrameFinisher {
 public:
  FrameFinisher(Job& job, RefineSettings settings, std::uint64_t wanted, StoredMesh reference,
                const OriginalFrames& original, std::vector<Attribute> attributes)
      : job_(job),
        settings_(std::move(settings)),
        reference_(std::move(reference)),
        first_(std::move(reference_.vertices)),
        original_(original) {
    settings_.decimation.sequence.reset();
    settings_.attributes = std::move(attributes);
    settings_.faces = wanted;
    settings_.unfolds_thoroughly = true;
    settings_.tile_faces = RefineSettings().tile_faces;
  }

  // Down to the wanted faces, by the frame's own cost.
  [[nodiscard]] StoredMesh simplified(const StoredMesh& mesh) const {
    const RefineMemory memory = refine_memory(job_.budget.left());
    StoredMesh own(job_, {0, settings_.attributes.size()}, MeshMemory::divide(memory.mesh));
    SpoolCursor<IndexedVertex> vertices(job_, mesh.vertices->records());
    Appender<IndexedVertex, VertexIndex> append(job_, *own.vertices);
    for (IndexedVertex vertex; vertices.next(vertex);) append.add(vertex);
    append.flush();
    if (mesh.attributes != nullptr)
      mesh.attributes->for_each_part(
          sizeof(double), [&](std::span<const std::byte> part) { own.attributes->append(part); });
    own.finish_vertices();
    SpoolCursor<FaceVertices> faces = mesh.face_cursor(job_);
    Appender<FaceVertices> append_face(job_, *own.faces);
    for (FaceVertices face{}; faces.next(face);) append_face.add(face);
    append_face.flush();
    own.finish_faces();
    own.face_count = mesh.face_count;
    return refine(job_, std::move(own), settings_, memory).mesh;
  }

  // Moves the vertices nearer to the frame's original in so many passes, and turns flipped faces
  // over beside it.
  void fit_and_unfold(std::size_t frame, StoredMesh& mesh, unsigned passes) {
    const RefineMemory memory = refine_memory(job_.budget.left());
    reference_.vertices = original_.vertices(job_, frame, *first_, memory.mesh);
    {
      const ReferenceMesh near(job_, reference_, share::refine::boxes(memory.lists));
      if (passes > 0) fit_to(near, mesh, passes, memory);
      job_.progress.begin("unfold", mesh.face_count, "faces");
      mesh.vertices = unfolded_vertices(job_, mesh, near, settings_, memory);
    }
    reference_.vertices.reset();
  }

 private:
  void fit_to(const ReferenceMesh& near, StoredMesh& mesh, unsigned passes,
              const RefineMemory& memory) const {
    Samples samples;
    samples.single = settings_.decimation.single;
    samples.area = area_of(job_, near.mesh());
    if (!(samples.area > 0)) return;
    FitReport fitted;
    (void)fit(job_, mesh, samples, {passes, true}, near, settings_, memory, fitted);
  }

  Job& job_;
  RefineSettings settings_;
  StoredMesh reference_;
  std::unique_ptr<VertexIndex> first_;
  const OriginalFrames& original_;
};

// How the frames come, once the budget is divided.
using TakeFrames = std::function<ReadSequence(const MemoryPlan& plan)>;

// `names`: of the files that `output` writes.
SequenceReport run(Job& job, const TakeFrames& take, FrameOutput& output,
                   const std::vector<std::string>& names, const SequenceOptions& options,
                   RunCheckpoint& checkpoint) {
  const Stopwatch watch;
  remove_stale_files(job.scratch.directory(), scratch_prefix);
  const auto plan_of = [taken = job.budget.used(), threads = job.threads](std::uint64_t total) {
    return MemoryPlan::divide(total, taken, threads, CellNeeds{});
  };
  const MemoryPlan plan = plan_of(job.budget.total());
  const Reservation fixed = job.budget.reserve(plan.fixed, "working threads");
  ReadSequence read = take(plan);
  SequenceMesh& sequence = read.sequence;
  SequenceReport& report = read.report;
  report.seconds.read = watch.seconds();

  const bool doubles = writes_doubles(options.encoding, sequence.double_positions);
  const std::uint64_t wanted = report.target_faces;
  const RefineSettings settings = settings_for(options, sequence, read.faces, doubles);
  const RefineMemory memory = refine_memory(job.budget.left());
  expect_beside_tile(job, sequence.mesh, {}, settings, plan_of);
  Refined refined = refine(job, std::move(sequence.mesh), settings, memory, checkpoint.directory());
  job.budget.expect_held({});
  StoredMesh& mesh = refined.mesh;
  report.tiles = refined.report.tiles;
  report.collapses = refined.report.collapses;
  const TopologyChanges& lost = refined.report.changes;
  report.lost = {lost.pieces, lost.area, lost.handles, lost.holes};
  if (report.resumed) {
    report.resumed->rounds = refined.report.rounds_before;
    report.resumed->tiles = refined.report.tiles_before;
  }
  report.seconds.refine = watch.seconds() - report.seconds.read;

  const MeshEncoder& encoder = output.encoder();
  const bool closed = encoder.needs_survey() && is_closed(job, mesh);
  const bool normals =
      options.normals || writes_normals(sequence.attributes, encoder, sequence.normals);
  FrameFinisher finisher(job, settings, wanted, std::move(refined.reference), sequence.original,
                         sequence.attributes);
  WrittenFrames written(checkpoint.directory());
  const std::size_t done = written.count(names);
  std::vector<std::string> files;  // what names them
  for (std::size_t frame = 0; frame < done; ++frame) files.push_back(written.identity(frame));
  report.output = {};
  if (done > 0) written.load_report(done - 1, report);
  for (const std::string& note : report.notes) job.note(note);
  const std::uint64_t bytes = report.output.bytes;
  const auto write_frame = [&](std::size_t frame) {
    StoredMesh own;
    if (mesh.face_count > wanted && options.per_frame > 0) own = finisher.simplified(mesh);
    StoredMesh& result = own.vertices != nullptr ? own : mesh;
    if (report.collapses > 0)
      finisher.fit_and_unfold(frame, result, static_cast<unsigned>(options.fit));
    if (frame == 0) report.area.output = area_of(job, result);
    MeshShape shape = shape_of(job, StoredOutput(result), encoder, normals, doubles,
                               sequence.double_positions, "simplified by winnow");
    shape.closed = closed;
    shape.attributes = sequence.attributes;
    const std::string file = output.write(frame, result, shape);
    report.output.faces = std::max(report.output.faces, result.face_count);
    report.output.vertices = std::max(report.output.vertices, result.vertices->size());
    report.output.bytes = bytes + output.bytes();
    report.notes = job.notes;
    if (file.empty()) return;
    written.add(frame, file, report);
    files.push_back(file);
    output.name_files();
  };
  for_each_result_frame(job, mesh, sequence.frames, done, share::left::packing(job.budget.left()),
                        write_frame);
  const std::string file = output.complete(mesh);
  if (files.empty()) files.push_back(file);
  report.output.bytes = bytes + output.bytes();
  report.target_met = report.output.faces <= wanted;
  if (!report.target_met)
    job.note(grouped(report.output.faces) + " faces are left instead of " + grouped(wanted) +
             ": fewer would change the topology or turn faces over in some frame");
  note_lost_area(job, "in the first frame ", report.area.input, report.area.output);
  report.output.format = output.format();
  report.notes = job.notes;
  checkpoint.settled(files, report);
  output.name_files();
  checkpoint.finish(job);
  take_usage(job, watch, report);
  return std::move(report);
}

// Of one input the frames are the targets in it.
std::vector<std::string> output_names(const RunRequest& request, std::size_t frames) {
  if (holds_all_frames(request.output, *request.sequence)) return {request.output};
  return names_of_frames(request.output,
                         request.inputs.size() == 1 ? frame_numbers(frames) : request.labels);
}

SequenceReport simplify_files(Job& job, const RunRequest& request, RunCheckpoint& checkpoint) {
  const SequenceOptions& options = *request.sequence;
  const bool read_before = checkpoint.has_mesh();
  const CheckpointDirectory* directory = checkpoint.directory();
  std::unique_ptr<MorphFrames> morphs;
  if (!read_before) {
    if (request.inputs.size() == 1)
      morphs = open_morph_frames(job, request.inputs.front(), options.from);
    if (request.inputs.size() < 2 && morphs == nullptr)
      throw Error(ErrorKind::usage,
                  "a sequence needs the files of two frames or more, or a glTF with morph targets; "
                  "for one mesh there is `simplify`");
  }
  const std::size_t frames = read_before         ? frames_in(*directory)
                             : morphs != nullptr ? morphs->frames()
                                                 : request.inputs.size();
  const std::vector<std::string> names = output_names(request, frames);
  std::unique_ptr<FrameOutput> output;
  std::vector<MorphClip> clips;
  {
    const WrittenFrames written(checkpoint.opened() ? directory : nullptr);
    const FilesThere there{[&](std::size_t number, const std::string& name) {
                             return checkpoint.is_written(number, name) ||
                                    written.has(number, name);
                           },
                           checkpoint.way_out()};
    if (holds_all_frames(request.output, options)) {
      if (read_before) clips = load_clips(job, *directory);
      if (morphs != nullptr) clips = morphs->clips();
      output = frames_to_glb(job, names.front(), clips, options, there);
    } else {
      output = frames_to_files(job, names, options, there);
    }
  }
  const auto take = [&](const MemoryPlan& plan) {
    const std::uint64_t quarter = plan.cluster.faces;
    if (read_before) return load_sequence(job, checkpoint, quarter / 2, quarter / 4 * 3);
    const AttributeRequest wish = wish_of(options, output->encoder());
    const std::unique_ptr<FrameReaders> readers =
        morphs != nullptr ? frames_of_morphs(*morphs, request.inputs.front(), wish)
                          : frames_of_files(job, request.inputs, options.from, wish);
    checkpoint.begun();
    ReadSequence read = read_sequence(job, *readers, plan, options);
    if (morphs != nullptr) read.report.input.bytes /= frames;  // each read all of the file
    if (checkpoint.opened()) read.report.resumed.emplace();
    save(job, checkpoint, read, clips);
    return read;
  };
  SequenceReport report = run(job, take, *output, names, options, checkpoint);
  report.input.names = request.inputs;
  report.output.names = names;
  return report;
}

SequenceReport sequence_with(Job& job, const RunRequest& request, RunCheckpoint checkpoint) {
  try {
    return in_arena(job, [&] { return simplify_files(job, request, checkpoint); });
  } catch (const Error& error) {
    checkpoint.fail(error);
  }
}

RunRequest request_for(const std::vector<std::string>& inputs, const std::string& output,
                       const SequenceOptions& options) {
  check(options);
  if (std::find(inputs.begin(), inputs.end(), "-") != inputs.end())
    throw Error(ErrorKind::usage, "the frames of a sequence are files, not standard input");
  const FrameNames frames = frame_names(inputs);
  RunRequest request{frames.inputs, output, {}};
  request.sequence = options;
  request.labels = frames.labels;
  return request;
}

}  // namespace

SequenceReport simplify_sequence(Context& context, const std::vector<std::string>& inputs,
                                 const std::string& output, const SequenceOptions& options) {
  const RunRequest request = request_for(inputs, output, options);
  Job job(context);
  return sequence_with(job, request, {});
}

SequenceReport simplify_sequence(Context& context, const std::vector<std::string>& inputs,
                                 const std::string& output, const SequenceOptions& options,
                                 const Checkpoint& settings) {
  const RunRequest request = request_for(inputs, output, options);
  Job job(context, settings.directory);
  return sequence_with(job, request, RunCheckpoint::begin(job, settings, request));
}

SequenceReport resume_sequence(Context& context, const Checkpoint& settings) {
  const Stopwatch watch;
  Job job(context, settings.directory);
  RunCheckpoint checkpoint = RunCheckpoint::open(job, settings);
  const RunRequest request = checkpoint.request(ResumableCall::sequence);
  const std::size_t frames = checkpoint.has_mesh() ? frames_in(*checkpoint.directory()) : 0;
  const std::vector<std::string> names = output_names(request, frames);
  if (!checkpoint.has_mesh() || !checkpoint.are_written(names)) {
    checkpoint.check_inputs();
    return sequence_with(job, request, std::move(checkpoint));
  }
  SequenceReport report;
  checkpoint.load_report(report);
  report.resumed.emplace().written = true;
  report.input.names = request.inputs;
  report.output.names = names;
  job.notes = report.notes;
  checkpoint.finish(job);
  take_usage(job, watch, report);
  return report;
}

SequenceReport simplify_sequence(Context& context, FrameSource& source, FrameSink& sink,
                                 const SequenceOptions& options) {
  check(options);
  Job job(context);
  return in_arena(job, [&] {
    const std::unique_ptr<FrameOutput> to = frames_to_sink(job, sink, options);
    const std::unique_ptr<FrameReaders> readers =
        frames_of_source(job, source, wish_of(options, to->encoder()));
    RunCheckpoint none;
    return run(
        job, [&](const MemoryPlan& plan) { return read_sequence(job, *readers, plan, options); },
        *to, {}, options, none);
  });
}

}  // namespace winnow
