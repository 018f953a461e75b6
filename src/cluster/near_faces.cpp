#include "cluster/near_faces.hpp"

#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "cluster/batch_cells.hpp"
#include "io/spool_records.hpp"
#include "read/for_each_batch.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>

namespace winnow {

namespace {

constexpr std::size_t corner_numbers = 9;
constexpr std::size_t buffered_faces = 1024;
constexpr unsigned recent_bits = 10;
constexpr PackedCell no_cell = UINT64_MAX;

}  // namespace

struct NearFaces::Worker {
  // Of each face its corners' coordinates, then what they carry, as in a FaceBatch.
  std::vector<double> numbers;
  // Cells beside, nearly each once.
  std::vector<PackedCell> beside;
  std::vector<PackedCell> recent = std::vector<PackedCell>(std::size_t{1} << recent_bits, no_cell);
  BatchCells cells;

  void add_beside(PackedCell at) {
    PackedCell& line = recent[quick_hash(at) >> (64 - recent_bits)];
    if (std::exchange(line, at) != at) beside.push_back(at);
  }
};

NearFaces::NearFaces(Job& job, std::size_t attributes, std::uint64_t memory)
    : job_(job), attributes_(attributes), faces_(job, memory) {}

void NearFaces::keep(Worker& worker) {
  const std::scoped_lock lock(keeping_);
  append_records<double>(faces_, worker.numbers);
  count_ += worker.numbers.size() / numbers_a_face();
  worker.numbers.clear();
}

void NearFaces::choose(Worker& worker, const FaceBatch& faces, const Grid& grid,
                       const CellSet& split, BatchBoxes* boxes) {
  worker.cells.find(faces, grid);
  Box box;
  bool finite = true;
  for (std::size_t c = 0; c < 3 && boxes != nullptr; ++c) {
    double low[3];
    double high[3];
    finite = finite && best_position_kernel().box(worker.cells.positions(c), low, high);
    if (finite) box.add(Box{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}, false});
  }
  if (boxes != nullptr) boxes->add(faces, finite ? box : Box{});
  for (std::size_t i = 0; i < faces.count; ++i) {
    if (faces.status[i] != FaceStatus::good || !worker.cells.inside(i)) continue;
    const std::array<PackedCell, 3> cell = worker.cells.of(i);
    if (!(split.has(cell[0]) || (cell[1] != cell[0] && split.has(cell[1])) ||
          (cell[2] != cell[0] && split.has(cell[2]))))
      continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<double, 3> corner = faces.corner(c, i);
      worker.numbers.insert(worker.numbers.end(), corner.begin(), corner.end());
      if (!split.has(cell[c])) worker.add_beside(cell[c]);
    }
    for (std::size_t a = 0; a < attributes_; ++a) {
      for (std::size_t c = 0; c < 3; ++c) worker.numbers.push_back(faces.attribute(a, c, i));
    }
  }
  if (worker.numbers.size() >= buffered_faces * corner_numbers) keep(worker);
}

template <typename EachBatch>
void NearFaces::choose_all(const EachBatch& each_batch, const Grid& grid, const CellSet& split,
                           CellSet& beside, BatchBoxes* boxes) {
  PerSlot<Worker> workers(job_.threads, [] { return std::make_unique<Worker>(); });
  each_batch([&](const FaceBatch& faces) { choose(workers.local(), faces, grid, split, boxes); });
  for (Worker* worker : workers.all()) {
    keep(*worker);
    for (const PackedCell cell : worker->beside) beside.set(cell);
  }
  faces_.finish();
}

void NearFaces::read(MeshReader& reader, const Grid& grid, const CellSet& split, CellSet& beside,
                     BatchBoxes& boxes) {
  reader.begin_faces();
  choose_all([&](const FaceSink& sink) { for_each_face_batch(job_, reader, sink, {}); }, grid,
             split, beside, &boxes);
}

void NearFaces::read_near(MeshReader& reader, const Grid& grid, const CellSet& split,
                          CellSet& beside, const BatchBoxes& boxes,
                          const std::vector<Box>& places) {
  reader.begin_faces();
  const auto wanted = [&](const RawBatch& batch) { return boxes.may_meet(batch, places); };
  choose_all([&](const FaceSink& sink) { for_each_face_batch(job_, reader, sink, {}, wanted); },
             grid, split, beside);
}

void NearFaces::take(const NearFaces& others, const Grid& grid, const CellSet& split,
                     CellSet& beside) {
  choose_all([&](const FaceSink& sink) { others.for_each_batch(sink); }, grid, split, beside);
}

bool NearFaces::for_each_batch(const FaceSink& sink, const std::function<bool()>& stop) const {
  const std::size_t numbers = numbers_a_face();
  PerSlot<FaceBatch> batches(job_.threads, [] { return std::make_unique<FaceBatch>(); });
  struct Chunk {
    std::uint64_t first = 0, count = 0;
  };
  bool stopped = false;
  pipeline<Chunk>(
      2 * std::size_t{job_.threads},
      [&](Chunk& chunk) {
        job_.progress.check_cancelled();
        stopped = stop && stop();
        if (stopped) return false;
        chunk = {next_, std::min<std::uint64_t>(buffered_faces, count_ - next_)};
        next_ += chunk.count;
        return chunk.count > 0;
      },
      [&](const Chunk& chunk) {
        const std::vector<double> all =
            read_records<double>(faces_, chunk.first * numbers, chunk.count * numbers);
        FaceBatch& batch = batches.local();
        batch.attributes.resize(3 * attributes_ * FaceBatch::capacity);
        batch.status.fill(FaceStatus::good);
        for (std::uint64_t at = 0; at < chunk.count; at += batch.count) {
          batch.count = std::min<std::size_t>(FaceBatch::capacity, chunk.count - at);
          for (std::size_t i = 0; i < batch.count; ++i) {
            const double* face = all.data() + (at + i) * numbers;
            for (std::size_t k = 0; k < corner_numbers; ++k)
              batch.position[k / 3][k % 3][i] = face[k];
            for (std::size_t k = 0; k < 3 * attributes_; ++k)
              batch.attributes[k * FaceBatch::capacity + i] = face[corner_numbers + k];
          }
          sink(batch);
        }
      });
  if (!stopped) next_ = 0;
  return stopped;
}

}  // namespace winnow
