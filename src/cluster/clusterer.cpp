#include "cluster/clusterer.hpp"

#include "base/cell_state.hpp"
#include "base/memory_shares.hpp"
#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "base/quadric.hpp"
#include "cluster/attribute_means.hpp"
#include "cluster/boundary_sum.hpp"
#include "cluster/build_mesh.hpp"
#include "cluster/cell_table.hpp"
#include "cluster/face_kinds.hpp"
#include "cluster/face_list.hpp"
#include "cluster/thread_sums.hpp"
#include "io/sorted_records.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

static_assert(kernel_capacity == FaceBatch::capacity);

// What one corner of a face adds to its cell.
void add_corner(CellSum& sum, const CornerSums& face, std::size_t corner, std::size_t i) {
  const std::int64_t weight = face.weight[corner][i];
  sum.weight += static_cast<std::uint64_t>(weight);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum.position[axis] +=
        weight * (face.place[corner][axis][i] & ((std::int64_t{1} << fraction_bits) - 1));
    sum.normal[axis] += weight * face.normal[axis][i];
  }
}

void add_corner(QuadricCellSum& sum, const CornerSums& face, std::size_t corner, std::size_t i) {
  add_corner(static_cast<CellSum&>(sum), face, corner, i);
  const std::int64_t weight = face.weight[corner][i];
  for (std::size_t k = 0; k < 5; ++k) sum.squares[k] += weight * face.squares[k][i];
  for (std::size_t k = 0; k < 3; ++k) sum.moment[k] += weight * face.moment[corner][k][i];
}

// What all three corners add together.
void add_face(CellSum& sum, const CornerSums& face, std::size_t i) {
  sum.weight += static_cast<std::uint64_t>(face.total_weight[i]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum.position[axis] += face.total_position[axis][i];
    sum.normal[axis] += face.total_normal[axis][i];
  }
}

void add_face(QuadricCellSum& sum, const CornerSums& face, std::size_t i) {
  add_face(static_cast<CellSum&>(sum), face, i);
  for (std::size_t k = 0; k < 5; ++k) sum.squares[k] += face.total_squares[k][i];
  for (std::size_t k = 0; k < 3; ++k) sum.moment[k] += face.total_moment[k][i];
}

template <typename Sum>
class ClustererOf final : public Clusterer {
 public:
  ClustererOf(Job& job, const ClusterSettings& settings, const ClusterMemory& memory)
      : job_(job),
        settings_(settings),
        memory_(memory),
        kernel_(best_corner_kernel()),
        table_memory_(job.budget.reserve(memory.table, "the table of cells")),
        boundary_share_(settings.keeps_boundaries() ? share::cluster::boundaries(memory.faces) : 0),
        face_memory_(job.budget.reserve(memory.faces - boundary_share_, "the list of faces")),
        table_(job, memory.table, memory.table_parts),
        face_runs_(job),
        workers_(job.threads, [this] {
          return std::make_unique<Worker>(
              job_, table_, (memory_.faces - boundary_share_) / job_.threads, face_runs_);
        }) {
    if (settings.keeps_boundaries())
      boundaries_ = std::make_unique<ThreadedRecords<BoundarySum>>(job, boundary_share_);
    if (settings.attributes.empty()) return;
    attributes_ = AttributeMeans::make(job, settings.attributes, AttributeMeans::Keys::cells,
                                       {memory.attributes, memory.table_parts});
  }

  void add(const FaceBatch& faces) override {
    Worker& worker = workers_.local();
    KernelInput input{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        input.position[corner][axis] = faces.position[corner][axis].data();
        input.single_position[corner][axis] = faces.single_position[corner][axis].data();
      }
    }
    input.single = faces.single;
    input.count = faces.count;
    for (std::size_t axis = 0; axis < 3; ++axis) input.origin[axis] = settings_.grid.origin[axis];
    input.inverse = settings_.grid.inverse;
    input.quadrics = std::is_same_v<Sum, QuadricCellSum>;
    input.sides = settings_.keeps_boundaries();
    kernel_(input, worker.corners);
    if (settings_.split != nullptr) settings_.split->rename(worker.corners, faces.count);
    worker.counts.faces += faces.count;

    worker.kinds.tell_apart(worker.corners, faces);
    const FaceIndices& inside = worker.kinds.inside;
    const bool sides = boundaries_ != nullptr;
    SortedList<BoundarySum>* list = sides ? &boundaries_->local() : nullptr;
    const auto take = [list](const BoundarySum& sum) { list->add(sum); };
    // Neighbours in the file are mostly neighbours in space: what follows in the same cell is added
    // up before the cell is looked for.
    for (std::size_t k = 0; k < inside.size();) {
      const std::int64_t cell = worker.corners.cell[0][inside[k]];
      Sum run{};
      std::array<std::int64_t, 3> area{};
      do {
        const std::size_t i = inside[k++];
        add_face(run, worker.corners, i);
        if (!sides) continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
          area[axis] += worker.corners.doubled_area[axis][i];
      } while (k < inside.size() && worker.corners.cell[0][inside[k]] == cell);
      worker.sums.entry(static_cast<PackedCell>(cell), run.weight).add(run);
      if (sides) worker.boundaries.sum_of(static_cast<PackedCell>(cell), take).add({}, area);
    }
    for (const std::size_t i : worker.kinds.pairs) add_pair(worker, i);
    for (const std::size_t i : worker.kinds.across) add_corners(worker, i);
    for (const std::size_t i : worker.kinds.bad) {
      if (worker.corners.kind[i] == close_corners && faces.status[i] == FaceStatus::good &&
          !faces.repeats_a_corner(i)) {
        add_corners(worker, i);
        if (sides) worker.boundaries.add_near_sides(worker.corners, i, take);
      } else {
        count_bad(worker, faces, i);
      }
    }
    if (worker.corners.clamped) count_clamped(worker, faces);
    if (attributes_ != nullptr) attributes_->add(faces, worker.corners);
    if (!sides) return;
    for (const std::size_t i : worker.kinds.pairs) {
      const auto alone = static_cast<std::size_t>(worker.corners.kind[i] - alone_a);
      worker.boundaries.add_pair(worker.corners, i, alone, take);
    }
    for (const std::size_t i : worker.kinds.across)
      worker.boundaries.add_across(worker.corners, i, take);
  }

  void add(const std::array<CellKey, 3>& cells) override {
    Worker& worker = workers_.local();
    for (const CellKey key : cells) {
      Sum sum{};
      sum.key = key;
      sum.weight = 1 | CellSum::used_bit;
      worker.sums.add(sum);
    }
    worker.faces.add(cell_face(cells[0], cells[1], cells[2]));
  }

  [[nodiscard]] bool wants_to_spill() const override {
    return table_.nearly_full() || (attributes_ != nullptr && attributes_->wants_to_spill());
  }
  void spill() override {
    if (attributes_ == nullptr || table_.nearly_full()) table_.spill();
    if (attributes_ != nullptr && attributes_->wants_to_spill()) attributes_->spill();
  }

  ClusterCounts counts() override {
    ClusterCounts sum;
    for (const Worker* worker : workers_.all()) sum.add(worker->counts);
    return sum;
  }

  ClusterResult finish() override {
    empty_caches();
    ClusterResult result{{job_, settings_.layout(), {memory_.vertices, memory_.result}}};
    if (settings_.for_refinement) {
      result.vanished = std::make_unique<Spool>(job_, share::cluster::vanished(memory_.vertices));
      result.several = std::make_unique<Spool>(job_, share::cluster::several(memory_.result));
    }
    build_vertices(job_, cells(), settings_, result);
    release_cells();
    MergedCursor<CellFace> all = faces();
    build_faces(job_, all, !settings_.for_refinement, result);
    return result;
  }

 private:
  struct Worker {
    Worker(Job& job, CellTable<Sum>& table, std::uint64_t face_memory, SortedRuns<CellFace>& runs)
        : sums(table, ThreadSums<Sum>::Keys::packed_cells), faces(job, face_memory, runs) {}

    CornerSums corners;
    ThreadSums<Sum> sums;
    FaceList faces;
    BoundaryCache boundaries;
    ClusterCounts counts;
    FaceKinds kinds;
  };

  // What workers still have of cells goes to the tables.
  void empty_caches() {
    const std::vector<Worker*> all = workers_.all();
    parallel_for(all.size(), [&all, this](std::size_t w) {
      Worker* worker = all[w];
      worker->sums.finish();
      if (boundaries_ == nullptr) return;
      SortedList<BoundarySum>& list = boundaries_->local();
      worker->boundaries.empty_into([&list](const BoundarySum& sum) { list.add(sum); });
    });
    job_.progress.check_cancelled();
  }

  // All cells, in key order: as they lie in the tables and in scratch.
  MergedCells<Sum> cells() {
    MergedCells<Sum> all;
    all.sums = table_.finish();
    if (attributes_ != nullptr) all.attributes = attributes_->finish();
    if (boundaries_ != nullptr)
      all.boundaries = std::make_unique<MergedCursor<BoundarySum>>(boundaries_->merged());
    return all;
  }

  // Makes room for faces.
  void release_cells() {
    boundaries_.reset();
    attributes_.reset();
    table_.release();
    table_memory_.release();
  }

  // All faces between cells, in key order.
  MergedCursor<CellFace> faces() {
    const std::vector<Worker*> all = workers_.all();
    parallel_for(all.size(), [&all](std::size_t w) { all[w]->faces.sort(); });
    std::vector<std::unique_ptr<RecordCursor<CellFace>>> cursors;
    for (Worker* worker : all) worker->faces.finish(cursors);
    face_runs_.add_cursors(cursors);
    return MergedCursor<CellFace>(std::move(cursors));
  }

  // Of a face with two corners in one cell.
  static void add_pair(Worker& worker, std::size_t i) {
    const CornerSums& face = worker.corners;
    const auto corner = static_cast<std::size_t>(face.kind[i] - alone_a);
    Sum alone{};
    add_corner(alone, face, corner, i);
    Sum both{};
    add_face(both, face, i);
    both.subtract(alone);
    worker.sums.entry(static_cast<PackedCell>(face.cell[corner][i]), alone.weight).add(alone);
    const std::size_t another = corner == 0 ? 1 : 0;
    worker.sums.entry(static_cast<PackedCell>(face.cell[another][i]), both.weight).add(both);
  }

  // Of any face, corner by corner.
  static void add_corners(Worker& worker, std::size_t i) {
    const CornerSums& face = worker.corners;
    const auto a = static_cast<PackedCell>(face.cell[0][i]);
    const auto b = static_cast<PackedCell>(face.cell[1][i]);
    const auto c = static_cast<PackedCell>(face.cell[2][i]);
    const bool kept = (a != b) & (a != c) & (b != c);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Sum& sum = worker.sums.entry(static_cast<PackedCell>(face.cell[corner][i]),
                                   static_cast<std::uint64_t>(face.weight[corner][i]));
      add_corner(sum, face, corner, i);
      if (kept) sum.weight |= CellSum::used_bit;
    }
    if (kept) worker.faces.add(cell_face(morton_key(a), morton_key(b), morton_key(c)));
  }

  void count_bad(Worker& worker, const FaceBatch& faces, std::size_t i) {
    const char* what = nullptr;
    if (faces.status[i] == FaceStatus::cropped) {
      ++worker.counts.cropped;
      return;
    }
    if (faces.status[i] == FaceStatus::out_of_range) {
      ++worker.counts.bad.out_of_range;
      what = "names a vertex that does not exist";
    } else if (faces.status[i] == FaceStatus::good && worker.corners.kind[i] == outside) {
      double farthest = 0;
      bool finite = true;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::array<double, 3> xyz = faces.corner(corner, i);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          finite &= std::isfinite(xyz[axis]);
          farthest =
              std::max(farthest, std::abs(settings_.grid.place(xyz[axis], axis) - axis_cells / 2));
        }
      }
      if (finite) {
        worker.counts.outside = std::max(worker.counts.outside, farthest);
        return;
      }
      ++worker.counts.bad.non_finite;
      what = "has a corner that is not finite";
    } else {
      ++worker.counts.bad.degenerate;
      what = "repeats a corner";
    }
    if (faces.first + i < worker.counts.first_bad.face)
      worker.counts.first_bad = {faces.first + i, what};
  }

  static void count_clamped(Worker& worker, const FaceBatch& faces) {
    for (std::size_t i = 0; i < faces.count; ++i) {
      if (faces.status[i] != FaceStatus::good) continue;
      const std::int32_t largest = std::max(
          {worker.corners.weight[0][i], worker.corners.weight[1][i], worker.corners.weight[2][i]});
      if (worker.corners.kind[i] <= close_corners && largest >= 1 << weight_limit_bits)
        ++worker.counts.clamped;
    }
  }

  Job& job_;
  ClusterSettings settings_;
  ClusterMemory memory_;
  CornerKernel kernel_;
  Reservation table_memory_;
  std::uint64_t boundary_share_;
  Reservation face_memory_;
  CellTable<Sum> table_;
  std::unique_ptr<AttributeMeans> attributes_;                // none where none are carried
  std::unique_ptr<ThreadedRecords<BoundarySum>> boundaries_;  // none for refinement
  SortedRuns<CellFace> face_runs_;
  PerSlot<Worker> workers_;
};

}  // namespace

MeshLayout ClusterSettings::layout() const {
  const bool quadrics = keep_quadrics && placement == Placement::quadric;
  return {quadrics ? sizeof(CellState) : 0, attributes.attributes.size()};
}

std::uint64_t ClusterMemory::per_thread(bool quadrics) {
  const std::uint64_t sums =
      quadrics ? ThreadSums<QuadricCellSum>::memory() : ThreadSums<CellSum>::memory();
  return sizeof(CornerSums) + sums + sizeof(FaceBatch) + BoundaryCache::bytes() +
         (std::uint64_t{256} << 10);  // stack, scratch of the kernel
}

std::uint64_t ClusterMemory::smallest_table(std::size_t parts, bool quadrics) {
  return parts * 4096 * (quadrics ? sizeof(QuadricCellSum) : sizeof(CellSum));
}

void ClusterCounts::add(const ClusterCounts& other) {
  faces += other.faces;
  bad.add(other.bad);
  cropped += other.cropped;
  clamped += other.clamped;
  if (other.first_bad.face < first_bad.face) first_bad = other.first_bad;
  outside = std::max(outside, other.outside);
}

std::unique_ptr<Clusterer> Clusterer::make(Job& job, const ClusterSettings& settings,
                                           const ClusterMemory& memory) {
  if (settings.placement == Placement::quadric)
    return std::make_unique<ClustererOf<QuadricCellSum>>(job, settings, memory);
  return std::make_unique<ClustererOf<CellSum>>(job, settings, memory);
}

}  // namespace winnow
