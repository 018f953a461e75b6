// The road: read, cluster, write.
#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "base/text.hpp"
#include "cluster/clusterer.hpp"
#include "cluster/resolution.hpp"
#include "io/arena.hpp"
#include "io/byte_sink.hpp"
#include "read/for_each_batch.hpp"
#include "read/mesh_reader.hpp"
#include "run/plan.hpp"
#include "run/write_mesh.hpp"
#include "write/mesh_encoder.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

// By how much the count may miss before the faces are clustered again with a better cell, and how often.
constexpr double tolerance = 0.10;
constexpr std::uint64_t most_runs = 3;

void check(const SimplifyOptions& options) {
  const int given = int{options.cell.has_value()} + int{options.grid.has_value()} +
                    int{options.faces.has_value()} + int{options.ratio.has_value()};
  if (given != 1) {
    throw Error(ErrorKind::usage,
                "say how fine the result shall be with exactly one of --cell, --grid, --faces and --ratio");
  }
  if (options.cell && !(*options.cell > 0 && std::isfinite(*options.cell))) {
    throw Error(ErrorKind::usage, "--cell takes a length above 0, not " + shortest(*options.cell));
  }
  if (options.grid && (*options.grid < 1 || *options.grid > axis_cells)) {
    throw Error(ErrorKind::usage, "--grid takes 1 to 2,097,152 cells, not " + grouped(*options.grid));
  }
  if (options.faces && *options.faces < 4) throw Error(ErrorKind::usage, "--faces takes at least 4");
  if (options.ratio && !(*options.ratio > 0 && *options.ratio <= 1)) {
    throw Error(ErrorKind::usage,
                "--ratio takes a part above 0 and at most 1 (or 100%), not " + shortest(*options.ratio));
  }
}

Access access_for(const SimplifyOptions& options) {
  if (options.cell) return Access::once;
  return options.grid ? Access::positions_first : Access::repeatedly;
}

bool quadrics(const SimplifyOptions& options) {
  return options.placement == Placement::quadric;
}

std::uint64_t count_faces(Job& job, MeshReader& reader) {
  if (reader.facts().faces) return *reader.facts().faces;
  std::uint64_t count = 0;
  job.progress.begin("count faces", 0, "faces");
  reader.begin_faces();
  for (RawBatch batch; reader.next_faces(batch);) {
    count += batch.count;
    job.progress.advance(batch.count);
  }
  return count;
}

class Simplification {
 public:
  Simplification(Job& job, MeshReader& reader, const SimplifyOptions& options, const MemoryPlan& plan,
                 SimplifyReport& report)
      : job_(job), reader_(reader), options_(options), plan_(plan), report_(report) {
    settings_.placement = options.placement;
    settings_.double_positions = reader.facts().double_positions;
  }

  ClusteredMesh run() {
    if (!options_.faces && !options_.ratio) {
      settings_.grid = options_.cell ? grid_of_cell() : grid_of_box();
      return cluster_once();
    }
    return cluster_to_count();
  }

 private:
  [[noreturn]] void refuse_empty() const {
    throw Error(ErrorKind::bad_input, "'" + reader_.name() + "' has no face that could be simplified");
  }

  Grid grid_of_cell() {
    const auto first = reader_.first_finite_position();
    if (!first) refuse_empty();
    return Grid::around(*first, *options_.cell);
  }

  Grid grid_of_box() {
    const Box box = measure_box(job_, reader_);
    if (box.empty) refuse_empty();
    return Grid::over(box, Grid::edge_for(box, *options_.grid));
  }

  ClusteredMesh cluster_to_count() {
    const std::uint64_t available = count_faces(job_, reader_);
    if (available == 0) refuse_empty();
    const std::uint64_t target =
        options_.faces
            ? *options_.faces
            : std::max<std::uint64_t>(
                  4, static_cast<std::uint64_t>(*options_.ratio * static_cast<double>(available) + 0.5));
    const CellCounts sample(job_, reader_, reader_.facts().vertices.value_or(available), target);
    if (sample.box().empty) refuse_empty();

    // What the sample foretells is corrected by what came of it.
    double wanted = static_cast<double>(target);
    for (report_.runs = 1;; ++report_.runs) {
      const double cell = sample.cell_for(wanted);
      settings_.grid = Grid::over(sample.box(), cell);
      ClusteredMesh mesh = cluster_once();
      const double miss = static_cast<double>(mesh.face_count) / static_cast<double>(target);
      if (std::abs(miss - 1) <= tolerance || report_.runs == most_runs || mesh.face_count == 0) {
        if (mesh.face_count != 0 && miss < 1 - tolerance && target >= available) {
          job_.note("the input has no more detail than these " + grouped(mesh.face_count) +
                    " faces at its own resolution");
        }
        return mesh;
      }
      const double better = sample.expected_faces(cell) / miss;
      const double next = sample.cell_for(better);
      if (std::abs(next / cell - 1) < 1e-3) return mesh;  // as fine as the input is
      job_.note("the sample misled: " + grouped(mesh.face_count) + " faces instead of " + grouped(target) +
                "; the faces were clustered again");
      wanted = better;
    }
  }

  ClusteredMesh cluster_once() {
    const std::unique_ptr<Clusterer> clusterer = Clusterer::make(job_, settings_, plan_.cluster);
    reader_.begin_faces();
    if (report_.seconds.read == 0) report_.seconds.read = watch_.seconds();
    job_.progress.begin("cluster", reader_.facts().faces.value_or(0), "faces");
    const FaceSink sink = [&](const FaceBatch& faces) { clusterer->add(faces); };
    const auto stop = [&] { return clusterer->wants_to_spill(); };
    while (for_each_face_batch(job_, reader_, sink, stop)) clusterer->spill();
    take_counts(clusterer->counts());
    reader_.rest();
    ClusteredMesh mesh = clusterer->finish();
    if (mesh.face_count == 0) refuse_result(mesh);
    return mesh;
  }

  void take_counts(const ClusterCounts& counts) {
    if (counts.outside > 0) {
      const double side = 2 * counts.outside * settings_.grid.cell;
      refuse_cell(settings_.grid.cell, side);
    }
    if (options_.strict && counts.first_bad.face != UINT64_MAX) {
      throw Error(ErrorKind::bad_input, "'" + reader_.name() + "': face " + grouped(counts.first_bad.face) +
                                            " " + counts.first_bad.what +
                                            "; without --strict such faces are counted and left out");
    }
    report_.input.faces = counts.faces;
    report_.input.bad_faces = counts.bad;
    report_.clamped_faces = counts.clamped;
  }

  [[noreturn]] void refuse_result(const ClusteredMesh& mesh) const {
    if (mesh.cells == 0) refuse_empty();
    throw Error(ErrorKind::failed, "no face is left: the whole model falls into " + grouped(mesh.cells) +
                                       " cells of " + shortest(settings_.grid.cell) +
                                       "; choose smaller cells");
  }

  Job& job_;
  MeshReader& reader_;
  const SimplifyOptions& options_;
  const MemoryPlan& plan_;
  SimplifyReport& report_;
  Stopwatch watch_;

 public:
  ClusterSettings settings_;
};

SimplifyReport simplify_in_arena(Job& job, const std::string& input, const std::string& output,
                                 const SimplifyOptions& options) {
  const Stopwatch watch;
  // Before a pipe is waited for; of a file, decompressing may need more, and the message should say it all.
  if (input == "-") MemoryPlan::divide(job.budget.total(), 0, job.threads, quadrics(options));
  const std::unique_ptr<MeshEncoder> encoder = make_encoder(options.to, output);
  remove_stale_files(job.scratch.directory(), scratch_prefix);
  ByteSink sink(job, output, options.force);
  SimplifyReport report;

  // Decompressing takes memory of its own, which shows with the first bytes; the rest is divided.
  job.budget.expect(MemoryPlan::smallest_for(job.threads, quadrics(options)));
  std::unique_ptr<ByteSource> source = open_source(job, input);
  source->peek(1);
  const MemoryPlan plan =
      MemoryPlan::divide(job.budget.total(), job.budget.used(), job.threads, quadrics(options));
  job.budget.expect(0);
  const Reservation fixed = job.budget.reserve(plan.fixed, "working threads");
  const std::unique_ptr<MeshReader> reader =
      open_reader(job, std::move(source), options.from, access_for(options), plan.reader);
  Simplification simplification(job, *reader, options, plan, report);
  const double opened = watch.seconds();
  const ClusteredMesh mesh = simplification.run();
  report.seconds.read += opened;
  report.seconds.cluster = watch.seconds() - report.seconds.read;

  const MeshShape shape{mesh.vertices->size(), mesh.face_count, options.normals || reader->facts().normals,
                        reader->facts().double_positions, "simplified by winnow"};
  write_mesh(job, mesh, shape, *encoder, sink);
  sink.finish();

  const double cell = simplification.settings_.grid.cell;
  report.input.vertices = reader->facts().vertices.value_or(0);
  report.input.bytes = reader->bytes();
  report.output = {mesh.face_count, mesh.vertices->size(), sink.written()};
  report.cell_size = cell;
  report.cells = mesh.cells;
  report.turned_faces = mesh.turned;
  report.fused_faces = mesh.fused;
  report.error_bound = cell * std::sqrt(3.0);
  report.spilled_bytes = job.scratch.written();
  report.peak_scratch_bytes = job.scratch.peak();
  report.peak_memory_bytes = peak_resident_bytes();
  report.seconds.total = watch.seconds();
  report.seconds.write = report.seconds.total - report.seconds.cluster - report.seconds.read;
  report.notes = job.notes;
  return report;
}

std::vector<std::string> passes_of(const InputOutlook& outlook, const SimplifyOptions& options) {
  std::vector<std::string> passes;
  if (outlook.copied_first) passes.emplace_back("copy the input to scratch");
  if (outlook.faces_kept) passes.emplace_back("keep the faces in scratch until the vertices are read");
  if (outlook.vertices_kept)
    passes.emplace_back("read the vertices into memory, or scratch where they do not fit");
  const std::string positions = outlook.facts.vertices ? "vertices" : "corners of all faces";
  if (options.grid) passes.push_back("measure the box of the " + positions);
  if (options.faces || options.ratio) {
    if (!outlook.facts.faces && options.ratio) passes.emplace_back("count the faces");
    passes.push_back("find the box and a rough cell size from the " + positions);
    passes.push_back("sample the " + positions + " for the cell size");
  }
  passes.emplace_back("cluster the faces");
  if (options.faces || options.ratio)
    passes.emplace_back("cluster them again, only if the sample misled by more than 10 %");
  passes.emplace_back("write the result");
  return passes;
}

}  // namespace

SimplifyReport simplify(Context& context, const std::string& input, const std::string& output,
                        const SimplifyOptions& options) {
  check(options);
  Job job(context);
  return in_arena(job, [&] { return simplify_in_arena(job, input, output, options); });
}

SimplifyPlan plan_simplify(Context& context, const std::string& input, const std::string& /*output*/,
                           const SimplifyOptions& options) {
  check(options);
  Job job(context);
  job.budget.expect(MemoryPlan::smallest_for(job.threads, quadrics(options)));
  const std::unique_ptr<ByteSource> source = open_source(job, input);
  source->peek(1);
  const MemoryPlan plan =
      MemoryPlan::divide(context.memory, job.budget.used(), job.threads, quadrics(options));
  const InputOutlook outlook = look_at(job, *source, options.from, access_for(options));
  SimplifyPlan out;
  out.memory = plan.parts();
  out.smallest_memory = plan.smallest + job.budget.used();
  out.passes = passes_of(outlook, options);
  out.faces = outlook.facts.faces;
  out.vertices = outlook.facts.vertices;
  if (out.faces) {
    std::uint64_t kept = outlook.copied_first ? outlook.bytes.value_or(0) : 0;
    if (outlook.vertices_kept) kept += out.vertices.value_or(0) * (outlook.facts.double_positions ? 24 : 12);
    if (outlook.faces_kept) kept += *out.faces * 16;
    out.scratch_worst = worst_scratch(*out.faces, quadrics(options)) + kept;
    out.scratch_expected = expected_scratch(*out.faces, plan, quadrics(options)) + kept;
    // A rate measured once for one thread (bench/RESULTS.md), for want of knowing the machine.
    out.seconds_expected = static_cast<double>(*out.faces) / (2.2e7 * job.threads);
  }
  return out;
}

}  // namespace winnow
