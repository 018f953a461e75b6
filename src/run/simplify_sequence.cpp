// The pipeline of a sequence: read all frames, refine them as one mesh, write each.
#include <winnow/error.hpp>
#include <winnow/options.hpp>
#include <winnow/sequence.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "base/trigonometry.hpp"
#include "io/arena.hpp"
#include "io/byte_sink.hpp"
#include "io/spool_records.hpp"
#include "measure/result_surface.hpp"
#include "options/check_ranges.hpp"
#include "run/attributes.hpp"
#include "run/detail.hpp"
#include "run/plan.hpp"
#include "run/refinement.hpp"
#include "run/result_sink.hpp"
#include "run/take_usage.hpp"
#include "run/write_blocks.hpp"
#include "run/write_mesh.hpp"
#include "sequence/frame_intake.hpp"
#include "sequence/frame_names.hpp"
#include "sequence/result_frames.hpp"
#include "stitch/refine.hpp"
#include "stitch/unfolded_mesh.hpp"
#include "write/formats.hpp"

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>
#include <vector>

#include <sys/stat.h>

namespace winnow {

namespace {

void check(const SequenceOptions& options) {
  if (!options.target.of_count())
    throw Error(ErrorKind::usage,
                "say how many faces each frame shall have with `faces` or `ratio`");
  check_ranges(sequence_options(), options);
}

// Where the frames of the result go.
class FrameOutput {
 public:
  virtual ~FrameOutput() = default;
  [[nodiscard]] virtual const MeshEncoder& encoder() const = 0;
  [[nodiscard]] virtual std::string format() const = 0;
  // Returns its bytes, before compression.
  virtual std::uint64_t write(std::size_t frame, const StoredMesh& mesh,
                              const MeshShape& shape) = 0;
};

// All frames stay, or none.
class FrameFiles final : public FrameOutput {
 public:
  FrameFiles(Job& job, std::vector<std::string> names, const SequenceOptions& options)
      : job_(job),
        names_(std::move(names)),
        format_(format_written(options.to, names_.front(), options.encoding)),
        force_(options.force),
        encoder_(make_encoder(options.to, names_.front(), options.encoding)),
        packing_(reserve_block(job, *encoder_, false)) {
    if (options.target.faces()) (void)encoder_->header({.faces = *options.target.faces()});
    for (const std::string& name : names_) {
      struct stat status {};
      if (::stat(name.c_str(), &status) != 0) continue;
      if (!S_ISREG(status.st_mode))
        throw Error(ErrorKind::usage, "'" + name + "' is no regular file; a frame needs one");
      if (!force_) throw Error(ErrorKind::usage, "'" + name + "' exists; " + ByteSink::by_force);
      job.written_over.push_back(FileNumber::of(status));
    }
  }
  FrameFiles(const FrameFiles&) = delete;
  FrameFiles& operator=(const FrameFiles&) = delete;
  ~FrameFiles() override {
    if (written_.size() == names_.size()) return;
    for (const auto& sink : written_) sink->take_back();
  }

  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  [[nodiscard]] std::string format() const override { return format_; }
  std::uint64_t write(std::size_t frame, const StoredMesh& mesh, const MeshShape& shape) override {
    auto sink = std::make_unique<ByteSink>(job_, names_[frame], force_);
    write_mesh(job_, mesh, shape, *encoder_, *sink);
    sink->finish_for_now();
    sink->release();
    const std::uint64_t bytes = sink->written();
    written_.push_back(std::move(sink));
    return bytes;
  }

 private:
  Job& job_;
  std::vector<std::string> names_;
  std::string format_;
  bool force_;
  std::unique_ptr<MeshEncoder> encoder_;
  Reservation packing_;
  std::vector<std::unique_ptr<ByteSink>> written_;
};

class FrameMeshes final : public FrameOutput {
 public:
  FrameMeshes(Job& job, FrameSink& sink, const SequenceOptions& options)
      : job_(job), sink_(sink), encoder_(make_encoder(Format::ply, {}, options.encoding)) {
    encoding_.encoding = options.encoding;
  }

  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  [[nodiscard]] std::string format() const override { return "memory"; }
  std::uint64_t write(std::size_t frame, const StoredMesh& mesh, const MeshShape& shape) override {
    Mesh out;
    const std::uint64_t bytes = MemorySink(job_, out, encoding_).write(mesh, shape);
    sink_.take(frame, std::move(out));
    return bytes;
  }

 private:
  Job& job_;
  FrameSink& sink_;
  SimplifyOptions encoding_;
  std::unique_ptr<MeshEncoder> encoder_;
};

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
                                  options.feature_weight};
  return settings;
}

[[noreturn]] void refuse_memory(const Job& job, const MemoryPlan& plan, std::uint64_t vertices) {
  const std::uint64_t missing = IntakeMemory::arrays_for(vertices) - plan.cluster.table;
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
                const OriginalFrames& original)
      : job_(job),
        settings_(std::move(settings)),
        reference_(std::move(reference)),
        first_(std::move(reference_.vertices)),
        original_(original) {
    settings_.decimation.sequence.reset();
    settings_.faces = wanted;
    settings_.tile_faces = RefineSettings().tile_faces;
  }

  // Down to the wanted faces, by the frame's own cost.
  [[nodiscard]] StoredMesh simplified(const StoredMesh& mesh) const {
    const RefineMemory memory = refine_memory(job_.budget.left());
    StoredMesh own(job_, {}, MeshMemory::divide(memory.mesh));
    SpoolCursor<IndexedVertex> vertices(job_, mesh.vertices->records());
    Appender<IndexedVertex, VertexIndex> append(job_, *own.vertices);
    for (IndexedVertex vertex; vertices.next(vertex);) append.add(vertex);
    append.flush();
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
    sequence = intake.run([&](std::uint64_t vertices) { refuse_memory(job, plan, vertices); });
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
  const RefineMemory memory = refine_memory(job.budget.left());
  expect_beside_tile(job, sequence.mesh, {}, settings, plan_of);
  Refined refined = refine(job, std::move(sequence.mesh), settings, memory);
  job.budget.expect_held({});
  StoredMesh& mesh = refined.mesh;
  report.target_faces = wanted;
  report.tiles = refined.report.tiles;
  report.collapses = refined.report.collapses;
  report.seconds.refine = watch.seconds() - report.seconds.read;

  const MeshEncoder& encoder = output.encoder();
  const bool closed = encoder.needs_survey() && is_closed(job, mesh);
  FrameFinisher finisher(job, settings, wanted, std::move(refined.reference), sequence.original);
  for_each_result_frame(
      job, mesh, sequence.frames, share::left::packing(job.budget.left()), [&](std::size_t frame) {
        StoredMesh own;
        if (mesh.face_count > wanted && options.per_frame > 0) own = finisher.simplified(mesh);
        StoredMesh& written = own.vertices != nullptr ? own : mesh;
        if (report.collapses > 0) finisher.unfold(frame, written);
        MeshShape shape = shape_of(job, written, encoder, sequence.normals, doubles,
                                   sequence.double_positions, "simplified by winnow");
        shape.closed = closed;
        report.output.bytes += output.write(frame, written, shape);
        report.output.faces = std::max(report.output.faces, written.face_count);
        report.output.vertices = std::max(report.output.vertices, written.vertices->size());
      });
  report.target_met = report.output.faces <= wanted;
  if (!report.target_met)
    job.note(grouped(report.output.faces) + " faces are left instead of " + grouped(wanted) +
             ": fewer would change the topology or turn faces over in some frame");
  report.output.format = output.format();
  take_usage(job, watch, report);
  return report;
}

}  // namespace

SequenceReport simplify_sequence(Context& context, const std::vector<std::string>& inputs,
                                 const std::string& output, const SequenceOptions& options) {
  check(options);
  if (inputs.size() < 2)
    throw Error(ErrorKind::usage,
                "a sequence needs the files of two frames or more; for one mesh there is "
                "`simplify`");
  if (std::find(inputs.begin(), inputs.end(), "-") != inputs.end())
    throw Error(ErrorKind::usage, "the frames of a sequence are files, not standard input");
  const FrameNames frames = frame_names(inputs);
  const std::vector<std::string> names = names_of_frames(output, frames.labels);
  Job job(context);
  SequenceReport report = in_arena(job, [&] {
    FrameFiles files(job, names, options);
    return run(job, *frames_of_files(job, frames.inputs, options.from), files, options);
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
    FrameMeshes meshes(job, sink, options);
    return run(job, *frames_of_source(job, source), meshes, options);
  });
}

}  // namespace winnow
