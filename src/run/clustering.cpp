#include "run/clustering.hpp"

#include <winnow/error.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "cluster/area_sum.hpp"
#include "cluster/open_cells.hpp"
#include "cluster/vertex_finders.hpp"
#include "cluster/welder.hpp"
#include "measure/result_surface.hpp"
#include "options/level_targets.hpp"
#include "read/for_each_batch.hpp"
#include "run/detail.hpp"
#include "run/input.hpp"
#include "run/safe_clustering.hpp"
#include "run/simplify_options.hpp"
#include "run/write_mesh.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace winnow {

namespace {

// By how much the count may miss before the faces are clustered again with a better cell, and how
// often. What is refined afterwards may miss by more.
constexpr double tolerance = 0.10;
constexpr double detail_tolerance = 0.4;
constexpr std::uint64_t most_runs_refined = 3;
constexpr std::uint64_t most_runs = 8;

// Where the finest cells leave less than this part of the faces that are wanted, clustering is no
// help.
constexpr double fine_enough = 0.5;
constexpr const char* much_damage = "it would damage much of the surface";
// An edge of a cell, beside the error that refinement may make.
constexpr double cell_for_error = 1.5;

std::uint64_t count_faces(Job& job, MeshReader& reader) {
  if (reader.facts().faces && !reader.facts().polygons) return *reader.facts().faces;
  std::atomic<std::uint64_t> count{0};
  job.progress.begin("count faces", 0, "faces");
  reader.begin_faces();
  for_each_face_batch(job, reader,
                      [&](const FaceBatch& faces) {
                        const auto* end = faces.status.begin() + faces.count;
                        const auto cropped =
                            std::count(faces.status.begin(), end, FaceStatus::cropped);
                        count += faces.count - static_cast<std::uint64_t>(cropped);
                      },
                      {});
  return count;
}

// What welding made of pairs of opposite faces.
void note_pairs(Job& job, const WeldResult& welded) {
  if (welded.fused == 0 && welded.flat_pairs == 0) return;
  const std::uint64_t pairs = welded.fused + welded.flat_pairs;
  std::string line = grouped(pairs) + (pairs == 1 ? " face" : " faces");
  line += " stood twice, once in each sense: ";
  const char* kept = "one side of each was kept, that of the first";
  if (welded.flat_pairs == 0) {
    line += kept;
  } else if (welded.fused == 0) {
    line += "they have no area and were left out";
  } else {
    line += grouped(welded.flat_pairs) + " without area were left out; of the others " + kept;
  }
  job.note(line);
}

}  // namespace

Clustering::Clustering(Job& job, MeshReader& reader, const SimplifyOptions& options,
                       TakenAttributes attributes, const MemoryPlan& plan, bool joined)
    : job_(job), reader_(reader), options_(options), plan_(plan), joined_(joined) {
  settings_.placement = options.placement;
  settings_.double_positions = writes_doubles(options.encoding, reader.facts().double_positions);
  if (reader.facts().mixed_positions && !welds(options)) {
    job.note(
        "some inputs have doubles and some floats, so boundaries between them may not be joined; "
        "`weld` DISTANCE joins what is near");
  }
  settings_.for_refinement = cost_of(options) != Refine::none;
  settings_.attributes = std::move(attributes.carried);
  report_.attributes = std::move(attributes.report);
  settings_.keep_quadrics = options.target.error().has_value();
}

Clustered Clustering::run() {
  Clustered out;
  out.mesh = as_asked();
  out.goals = std::move(goals_);
  out.normals = reader_.facts().normals;
  out.double_positions = reader_.facts().double_positions;
  out.attributes = settings_.attributes.attributes;
  if (fit_passes(options_) > 0) out.samples = samples();
  report_.cell_size = settings_.grid.cell;
  report_.input.vertices = reader_.facts().vertices.value_or(0);
  report_.input.bytes = reader_.bytes();
  report_.input.format = reader_.facts().format;
  out.report = std::move(report_);
  return out;
}

Samples Clustering::samples() {
  if (!lattice_)
    return sample_faces(job_, reader_, std::min(target_, available_), report_.area.input);
  return {nullptr, !reader_.facts().double_positions, report_.area.input};
}

std::unique_ptr<Spool> Clustering::map(MeshReader& unwelded, const Clustered& clustered) {
  const std::uint64_t vertices =
      reader_.facts().vertices.value_or(3 * clustered.report.input.faces);
  const MakeFinder finder = lattice_ ? welded_finder(clustered.mesh, *lattice_)
                                     : clustered_finder(clustered.mesh, settings_.grid,
                                                        cells_ ? &*cells_ : nullptr, shift_);
  return map_of_input(job_, unwelded, reader_, vertices, finder,
                      share::left::map(job_.budget.left()));
}

StoredMesh Clustering::as_asked() {
  if (cost_of(options_) == Refine::none) report_.clustered = {true, clustering_alone};
  if (options_.target.of_cells()) {
    settings_.grid = options_.target.cell() ? grid_of_cell() : grid_of_box();
    ClusterResult clustered = once();
    if (clustered.mesh.face_count == 0) refuse_result(clustered);
    return reported(std::move(clustered));
  }
  available_ = count_faces(job_, reader_);
  if (available_ == 0) refuse_empty();
  if (options_.target.error()) return to_error();
  for (const Target& target : targets_of(options_))
    goals_.push_back({faces_wanted(target, available_).value_or(0), 0});
  target_ = goals_.front().faces;
  report_.target_faces = target_;
  return cost_of(options_) == Refine::none ? reported(to_count(sample(target_), target_, tolerance))
                                           : to_detail();
}

Grid Clustering::grid_of_cell() {
  const auto first = reader_.first_finite_position();
  if (!first) refuse_empty();
  return Grid::around(*first, *options_.target.cell());
}

Grid Clustering::grid_of_box() {
  const Box box = measure_box_of_faces(job_, reader_);
  if (box.empty) refuse_empty();
  return Grid::over(box, Grid::edge_for(box, *options_.target.grid()));
}

StoredMesh Clustering::to_error() {
  const Box box =
      options_.target.error()->relative
          ? measure_box_of_faces(job_, reader_)
          : measure_surface(job_, reader_, reader_.facts().vertices.value_or(available_));
  if (box.empty) refuse_empty();
  for (const Target& target : targets_of(options_))
    goals_.push_back({0, target.error()->length(box.diagonal())});
  error_ = goals_.front().error;
  const double cell = cell_for_error * error_;
  const Detail detail = detail_for_error(options_, available_);
  if (detail.welded) return welded(detail.reason);
  if (cell >= Grid::edge_for(box, axis_cells / 2)) {
    report_.clustered = {true, "cells of 1.5 times the error leave less than half of the faces"};
    settings_.grid = Grid::over(box, cell);
    ClusterResult coarse = once();
    if (coarse.mesh.face_count < available_ / 2) {
      std::optional<SafeMesh> safe = safely(box, std::move(coarse));
      return safe ? reported(std::move(safe->result)) : welded(much_damage);
    }
  }
  return welded("cells of 1.5 times the error would leave half of the faces or more");
}

StoredMesh Clustering::to_detail() {
  const Detail detail = detail_for(options_, available_, target_);
  if (detail.welded) return welded(detail.reason);
  report_.clustered = {true, detail.reason};
  const CellCounts cells = sample(detail.faces);
  const auto wanted = static_cast<double>(detail.faces);
  if (cells.expected_faces(cells.cell_for(wanted)) >= fine_enough * wanted) {
    std::optional<SafeMesh> safe =
        safely(cells.box(), to_count(cells, detail.faces, detail_tolerance));
    return safe ? reported(std::move(safe->result)) : welded(much_damage);
  }
  job_.note(
      "the finest cells in a box of " + shortest(cells.box().longest_side()) +
      " are too coarse for this count, so all faces were refined: some vertices may be far off");
  return welded("the finest cells are too coarse");
}

std::optional<SafeMesh> Clustering::safely(const Box& box, ClusterResult coarse) {
  std::optional<SafeMesh> safe =
      without_damage(job_, reader_, settings_, plan_.cluster, box, available_, std::move(coarse),
                     std::move(open_cells_));
  if (safe) {
    report_.split_cells = safe->cells.size();
    cells_.emplace(std::move(safe->cells));
    shift_ = safe->shift;
  } else {
    job_.note("much of the surface is thinner than cells of " + shortest(settings_.grid.cell) +
              " or full of holes, so all faces were refined");
  }
  return safe;
}

StoredMesh Clustering::welded(const std::string& reason) {
  report_.clustered = {false, reason};
  cells_.reset();
  settings_.grid = {};
  const WeldMemory memory{plan_.cluster.table,
                          plan_.cluster.vertices,
                          plan_.cluster.result,
                          {plan_.cluster.attributes, plan_.cluster.table_parts}};
  if (report_.seconds.read == 0) report_.seconds.read = watch_.seconds();
  const WeldSettings settings{settings_.attributes, !settings_.double_positions,
                              &report_.area.input, &lattice_.emplace()};
  WeldResult result = weld(job_, reader_, settings, memory, available_);
  take_counts(result.counts);
  note_pairs(job_, result);
  StoredMesh& mesh = result.mesh;
  if (mesh.face_count == 0) refuse_empty();
  // A third of the edges is listed, or sorted in eight bytes each.
  if (mesh.face_count <= always_full || 16 * mesh.face_count <= plan_.cluster.table) {
    const CountedSurface surface = count_surface(job_, mesh, plan_.cluster.table);
    report_.topology.input = surface.edges;
    report_.topology.input_pieces = surface.pieces;
  }
  report_.cells = mesh.vertices->size();
  report_.merged_opposite_faces = result.fused;
  return std::move(mesh);
}

CellCounts Clustering::sample(std::uint64_t target) {
  CellCounts sample(job_, reader_, reader_.facts().vertices.value_or(available_), target);
  if (sample.box().empty) refuse_empty();
  return sample;
}

// Cells that were tried and how many faces they gave. On most surfaces the sample is right the
// first time. On others the count is searched for between the nearest cells on either side, as if
// it were a power of the cell.
ClusterResult Clustering::to_count(const CellCounts& sample, std::uint64_t target,
                                   double tolerated) {
  const auto wanted = static_cast<double>(target);
  // What is refined afterwards may miss, so the old cost of a few runs is the limit there.
  const std::uint64_t runs = settings_.for_refinement ? most_runs_refined : most_runs;
  CellSearch search(sample, wanted);
  for (report_.cluster_passes = 1;; ++report_.cluster_passes) {
    settings_.grid = Grid::over(sample.box(), search.next());
    ClusterResult clustered = once();
    const std::uint64_t faces = clustered.mesh.face_count;
    search.add(settings_.grid.cell, faces);
    const double miss = static_cast<double>(faces) / wanted;
    if (std::abs(miss - 1) <= tolerated) return clustered;
    const bool last = report_.cluster_passes == runs || search.exhausted();
    if (!last) {
      job_.note("the sample misled: " + grouped(faces) + " faces instead of " + grouped(target) +
                "; the faces were clustered again");
      continue;
    }
    if (search.best() != settings_.grid.cell) {
      ++report_.cluster_passes;
      settings_.grid = Grid::over(sample.box(), search.best());
      clustered = once();
    }
    if (clustered.mesh.face_count == 0 && !settings_.for_refinement) refuse_result(clustered);
    note_missed_count(search, clustered.mesh.face_count, target);
    return clustered;
  }
}

void Clustering::note_missed_count(const CellSearch& search, std::uint64_t faces,
                                   std::uint64_t target) {
  const std::string line = grouped(faces) + " faces instead of " + grouped(target) + ": ";
  if (faces < target && target >= available_) {
    job_.note("the input has no more detail than these " + grouped(faces) +
              " faces at its own resolution");
  } else if (faces < target && search.finest()) {
    job_.note(line + "finer cells do not exist in a box of " +
              shortest(search.box().longest_side()) + "; some vertices may be far off, see `crop`");
  } else if (settings_.for_refinement) {
    job_.note(line + "the count changes too fast with the size of cells");
  } else {
    job_.note(
        line +
        "no size of cells that was tried comes nearer; `faces` without `refine` none is exact");
  }
}

ClusterResult Clustering::once() {
  ClusterMemory memory = settings_.for_refinement ? safe_memory(plan_.cluster) : plan_.cluster;
  std::optional<OpenCells> open;
  if (settings_.for_refinement &&
      (options_.boundary == Boundary::keep || options_.target.error())) {
    const std::uint64_t bytes = share::cluster::boundaries(memory.faces);
    memory.faces -= bytes;
    open.emplace(job_, settings_.grid, !settings_.double_positions, bytes);
  }
  const std::unique_ptr<Clusterer> clusterer = Clusterer::make(job_, settings_, memory);
  reader_.begin_faces();
  if (report_.seconds.read == 0) report_.seconds.read = watch_.seconds();
  job_.progress.begin("cluster", reader_.facts().faces.value_or(0), "faces");
  AreaSum area(job_.threads, settings_.grid.cell * settings_.grid.cell);
  const FaceSink sink = [&](const FaceBatch& faces) {
    clusterer->add(faces);
    area.add(faces);
    if (open) open->add(faces);
  };
  const auto stop = [&] { return clusterer->wants_to_spill(); };
  while (for_each_face_batch(job_, reader_, sink, stop)) clusterer->spill();
  take_counts(clusterer->counts());
  report_.area.input = area.value();
  reader_.release_memory();
  if (open) open_cells_ = open->finish();
  return clusterer->finish();
}

void Clustering::take_counts(const ClusterCounts& counts) {
  if (counts.outside > 0) {
    const double side = 2 * counts.outside * settings_.grid.cell;
    refuse_cell(settings_.grid.cell, side);
  }
  if (options_.strict && counts.first_bad.face != UINT64_MAX)
    refuse_bad_face(reader_.name(), counts.first_bad);
  report_.input.faces = counts.faces;
  report_.input.bad_faces = counts.bad;
  report_.input.cropped_faces = counts.cropped;
  report_.weight_clamped_faces = counts.clamped;
}

void Clustering::refuse_empty() const {
  if (!options_.crop && reader_.facts().faces == std::uint64_t{0})
    refuse_without_faces(reader_, "simplified");
  throw Error(ErrorKind::bad_input,
              "'" + reader_.name() + "' has no face that could be simplified" +
                  (options_.crop ? " in the box of `crop`; `info` tells where the mesh is" : "") +
                  (joined_ ? "; `weld` joined too many vertices, choose a smaller distance" : ""));
}

StoredMesh Clustering::reported(ClusterResult clustered) {
  report_.cells = clustered.cells;
  report_.reoriented_faces = clustered.turned;
  report_.merged_opposite_faces = clustered.fused;
  return std::move(clustered.mesh);
}

void Clustering::refuse_result(const ClusterResult& clustered) const {
  if (clustered.cells == 0) refuse_empty();
  if (!options_.target.of_cells()) {
    throw Error(ErrorKind::failed,
                "no face is left: all cells that were tried, down to " +
                    shortest(settings_.grid.cell) +
                    ", are too coarse; leave `refine` none out, or use `crop` if some "
                    "vertices are far off");
  }
  throw Error(ErrorKind::failed,
              "no face is left: the whole model falls into " + grouped(clustered.cells) +
                  " cells of " + shortest(settings_.grid.cell) + "; choose smaller cells" +
                  (options_.target.cell() ? "" : ", or `crop` if some vertices are far off"));
}

}  // namespace winnow
