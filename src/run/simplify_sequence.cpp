// The pipeline of a sequence: read all frames, refine them as one mesh, write each.
#include <winnow/error.hpp>
#include <winnow/options.hpp>
#include <winnow/sequence.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "base/trigonometry.hpp"
#include "io/arena.hpp"
#include "io/spool_records.hpp"
#include "measure/result_surface.hpp"
#include "options/check_ranges.hpp"
#include "read/morph_frames.hpp"
#include "run/attributes.hpp"
#include "run/detail.hpp"
#include "run/frame_output.hpp"
#include "run/plan.hpp"
#include "run/refinement.hpp"
#include "run/take_usage.hpp"
#include "run/write_mesh.hpp"
#include "sequence/frame_intake.hpp"
#include "sequence/frame_names.hpp"
#include "sequence/result_frames.hpp"
#include "stitch/refine.hpp"
#include "stitch/unfolded_mesh.hpp"

#include <algorithm>
#include <bit>
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

// Whatever has a meaningful mean and the output can hold. Normals are computed anew, so none is
// missed.
AttributeRequest wish_of(const MeshEncoder& encoder) {
  AttributeRequest wish;
  wish.names.reset();
  wish.refusal = [&encoder](const Attribute& attribute, std::span<const Attribute> wanted) {
    return names_normal(attribute) ? std::string() : encoder.attribute_refusal(attribute, wanted);
  };
  return wish;
}

// Fewer where there are many frames, so that a tile takes about the same memory. With 64 frames or
// fewer it has the 2^15 faces and more that its borders hardly show in.
std::uint64_t tile_faces_for(std::size_t frames) {
  return std::clamp<std::uint64_t>((std::uint64_t{1} << 21) / std::bit_ceil(frames),
                                   std::uint64_t{1} << 11, std::uint64_t{1} << 16);
}

// What frames remove by themselves, of so many faces.
std::uint64_t rounded_part(double part, std::uint64_t faces, std::uint64_t wanted) {
  const auto removed = static_cast<double>(faces - std::min(faces, wanted));
  return static_cast<std::uint64_t>(part * removed + 0.5);
}

RefineSettings settings_for(const SequenceOptions& options, const SequenceMesh& sequence,
                            std::uint64_t wanted, bool doubles) {
  RefineSettings settings;
  settings.faces = wanted + rounded_part(options.per_frame, sequence.mesh.face_count, wanted);
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

[[noreturn]] void refuse_memory(const Job& job, const MemoryPlan& plan, std::uint64_t vertices,
                                std::uint64_t bytes) {
  const std::uint64_t missing = bytes - plan.cluster.table;
  const std::uint64_t enough = job.budget.total() + share::plan::cells.whole(missing);
  throw Error(ErrorKind::resources,
              "a memory budget of " + human_bytes(job.budget.total()) +
                  " is too small for frames of " + grouped(vertices) +
                  " vertices, one of which is held in memory; enough is `memory` " +
                  size_option((enough / mebibyte + 2) * mebibyte));
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

  // Turns flipped faces over, beside the frame's original.
  void unfold(std::size_t frame, StoredMesh& mesh) {
    const RefineMemory memory = refine_memory(job_.budget.left());
    reference_.vertices = original_.vertices(job_, frame, *first_, memory.mesh);
    job_.progress.begin("unfold", mesh.face_count, "faces");
    mesh.vertices = unfolded_vertices(job_, mesh, reference_, settings_, memory);
    reference_.vertices.reset();
  }

 private:
  Job& job_;
  RefineSettings settings_;
  StoredMesh reference_;
  std::unique_ptr<VertexIndex> first_;
  const OriginalFrames& original_;
};

SequenceReport run(Job& job, FrameReaders& readers, FrameOutput& output,
                   const SequenceOptions& options) {
  const Stopwatch watch;
  remove_stale_files(job.scratch.directory(), scratch_prefix);
  const auto plan_of = [taken = job.budget.used(), threads = job.threads](std::uint64_t total) {
    return MemoryPlan::divide(total, taken, threads, CellNeeds{});
  };
  const MemoryPlan plan = plan_of(job.budget.total());
  const Reservation fixed = job.budget.reserve(plan.fixed, "working threads");
  SequenceReport report;
  SequenceMesh sequence;
  {
    const std::uint64_t quarter = plan.cluster.faces;
    FrameIntake intake(
        job, readers, {plan.reader, plan.cluster.table, quarter / 2, quarter / 2 * 3, quarter / 4});
    sequence = intake.run([&](std::uint64_t vertices,
                              std::uint64_t bytes) { refuse_memory(job, plan, vertices, bytes); },
                          [&](std::vector<Attribute>& attributes,
                              const std::vector<MeshReader::AttributeRange>& ranges) {
                            settle_colors(job, attributes, ranges);
                          });
  }
  note_dropped(job, sequence.dropped);
  if (sequence.mesh.face_count == 0)
    throw Error(ErrorKind::bad_input, readers.name(0) + " has no face that could be simplified");
  report.input.format = sequence.format;
  report.input.frames = sequence.frames;
  report.input.faces = sequence.faces;
  report.input.vertices = sequence.vertices;
  report.input.bytes = sequence.bytes;
  report.joined = sequence.joined;
  report.bad_faces = sequence.bad_faces;
  report.seconds.read = watch.seconds();

  const bool doubles = writes_doubles(options.encoding, sequence.double_positions);
  const std::uint64_t wanted = faces_wanted(options.target, sequence.mesh.face_count).value_or(0);
  const RefineSettings settings = settings_for(options, sequence, wanted, doubles);
  report.area.input = area_of(job, sequence.mesh);
  const RefineMemory memory = refine_memory(job.budget.left());
  expect_beside_tile(job, sequence.mesh, {}, settings, plan_of);
  Refined refined = refine(job, std::move(sequence.mesh), settings, memory);
  job.budget.expect_held({});
  StoredMesh& mesh = refined.mesh;
  report.target_faces = wanted;
  report.tiles = refined.report.tiles;
  report.collapses = refined.report.collapses;
  const TopologyChanges& lost = refined.report.changes;
  report.lost = {lost.pieces, lost.area, lost.handles, lost.holes};
  report.seconds.refine = watch.seconds() - report.seconds.read;

  const MeshEncoder& encoder = output.encoder();
  const bool closed = encoder.needs_survey() && is_closed(job, mesh);
  FrameFinisher finisher(job, settings, wanted, std::move(refined.reference), sequence.original,
                         sequence.attributes);
  for_each_result_frame(
      job, mesh, sequence.frames, share::left::packing(job.budget.left()), [&](std::size_t frame) {
        StoredMesh own;
        if (mesh.face_count > wanted && options.per_frame > 0) own = finisher.simplified(mesh);
        StoredMesh& written = own.vertices != nullptr ? own : mesh;
        if (report.collapses > 0) finisher.unfold(frame, written);
        if (frame == 0) report.area.output = area_of(job, written);
        MeshShape shape = shape_of(job, written, encoder, sequence.normals, doubles,
                                   sequence.double_positions, "simplified by winnow");
        shape.closed = closed;
        shape.attributes = sequence.attributes;
        output.write(frame, written, shape);
        report.output.faces = std::max(report.output.faces, written.face_count);
        report.output.vertices = std::max(report.output.vertices, written.vertices->size());
      });
  output.finish(mesh);
  report.output.bytes = output.bytes();
  report.target_met = report.output.faces <= wanted;
  if (!report.target_met)
    job.note(grouped(report.output.faces) + " faces are left instead of " + grouped(wanted) +
             ": fewer would change the topology or turn faces over in some frame");
  note_lost_area(job, "in the first frame ", report.area.input, report.area.output);
  report.output.format = output.format();
  take_usage(job, watch, report);
  return report;
}

}  // namespace

SequenceReport simplify_sequence(Context& context, const std::vector<std::string>& inputs,
                                 const std::string& output, const SequenceOptions& options) {
  check(options);
  if (std::find(inputs.begin(), inputs.end(), "-") != inputs.end())
    throw Error(ErrorKind::usage, "the frames of a sequence are files, not standard input");
  Job job(context);
  FrameNames frames = frame_names(inputs);
  std::vector<std::string> names;
  SequenceReport report = in_arena(job, [&] {
    const std::unique_ptr<MorphFrames> morphs =
        inputs.size() == 1 ? open_morph_frames(job, inputs.front(), options.from) : nullptr;
    if (morphs == nullptr && inputs.size() < 2)
      throw Error(ErrorKind::usage,
                  "a sequence needs the files of two frames or more, or a glTF with morph targets; "
                  "for one mesh there is `simplify`");
    if (morphs != nullptr) frames.labels = frame_numbers(morphs->frames());
    std::unique_ptr<FrameOutput> to;
    if (holds_all_frames(output, options)) {
      names = {output};
      to = frames_to_glb(job, output,
                         morphs != nullptr ? morphs->clips() : std::vector<MorphClip>(), options);
    } else {
      names = names_of_frames(output, frames.labels);
      to = frames_to_files(job, names, options);
    }
    const AttributeRequest wish = wish_of(to->encoder());
    const std::unique_ptr<FrameReaders> readers =
        morphs != nullptr ? frames_of_morphs(*morphs, inputs.front(), wish)
                          : frames_of_files(job, frames.inputs, options.from, wish);
    SequenceReport done = run(job, *readers, *to, options);
    if (morphs != nullptr) done.input.bytes /= morphs->frames();  // each read all of the file
    return done;
  });
  report.input.names = frames.inputs;
  report.output.names = names;
  return report;
}

SequenceReport simplify_sequence(Context& context, FrameSource& source, FrameSink& sink,
                                 const SequenceOptions& options) {
  check(options);
  Job job(context);
  return in_arena(job, [&] {
    const std::unique_ptr<FrameOutput> to = frames_to_sink(job, sink, options);
    return run(job, *frames_of_source(job, source, wish_of(to->encoder())), *to, options);
  });
}

}  // namespace winnow
