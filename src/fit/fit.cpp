#include "fit/fit.hpp"

#include "fit/farther.hpp"
#include "fit/hits.hpp"
#include "fit/vertex_fit.hpp"
#include "io/spool_records.hpp"
#include "stitch/tiles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace winnow {

namespace {

// No face turns farther in one pass than the angle with this cosine, 20 degrees: a face that does
// is mostly one that flips.
constexpr double least_cosine_of_pass = 0.94;
// Samples do not meet the farthest places of all, but nearly so far ones.
constexpr double part_of_largest = 0.9;
// How often faces of the reference may be looked at for each face, in the mean.
constexpr std::uint64_t looks_a_fitted_face = 10'000;

double rms_of(const SampleSums& sums, double gain = 0) {
  if (sums.count == 0) return 0;
  return std::sqrt(std::max(sums.squares - gain, 0.0) / static_cast<double>(sums.count));
}

// A tile's own vertices, how many of them have moved, and what that took off the squares.
struct FittedTile {
  std::vector<IndexedVertex> vertices;
  std::uint64_t moved = 0;
  double gain = 0;
};
// What one pass did.
struct Pass {
  std::unique_ptr<VertexIndex> vertices;
  SampleSums samples;  // before
  std::uint64_t moved = 0;
  double gain = 0;
};

// A free vertex has no faces but the tile's own ones, which are those that begin with a vertex of
// the tile. So the sums of other faces need not be known. The exception is a face at a hub, whose
// vertices are locked.
std::vector<FaceSums> sums_of(const Spool& sums, const Tiling& tiling, std::size_t number,
                              const Tile& tile) {
  std::vector<FaceSums> own(tile.faces.size());
  if (tile.hubs.empty()) {
    const std::uint64_t first = tiling.first_face(number);
    const std::uint64_t count = tiling.first_face(number + 1) - first;
    sums.read(first * sizeof(FaceSums), std::as_writable_bytes(std::span(own).first(count)));
  }
  return own;
}

std::uint64_t fitted_tile_memory(std::uint64_t vertices, std::uint64_t faces) {
  const std::uint64_t tile = vertices * (sizeof(IndexedVertex) + sizeof(Point) + 1) +
                             faces * (sizeof(FaceVertices) + sizeof(std::uint32_t));
  return tile + faces * sizeof(FaceSums) + vertex_fit_memory(vertices, faces) +
         ReferenceMesh::Reader::memory() + ReferenceMesh::Reader::most_faces() * sizeof(Triangle);
}

class Fitting {
 public:
  Fitting(Job& job, SampledSurface& samples, bool single, bool boundaries,
          const ReferenceMesh& reference, const RefineSettings& settings,
          const RefineMemory& memory)
      : job_(job), samples_(samples), reference_(reference), settings_(settings), memory_(memory) {
    vertex_.single = settings.decimation.single;
    vertex_.least_cosine = std::max(settings.decimation.least_cosine, least_cosine_of_pass);
    vertex_.rounding = coordinate_rounding(single || vertex_.single);
    vertex_.boundaries = boundaries;
  }

  Pass once(const StoredMesh& mesh) {
    Spool sums(job_, memory_.logs);
    Pass pass;
    pass.samples = sum_up_samples(job_, mesh, samples_, memory_.tiles, sums);
    vertex_.far = part_of_largest * pass.samples.largest;
    pass.vertices = std::make_unique<VertexIndex>(job_, memory_.mesh);
    const Tiles tiles(job_, mesh, settings_, memory_);
    const Reservation beside = job_.budget.reserve(job_.threads * memory_beside(tiles), "fitting");
    tiles.for_each<FittedTile>(
        0,
        [&](std::size_t number, FittedTile& fitted) {
          Tile tile = tiles.load(number, {});
          lock_beside_hubs(tile);
          const std::vector<FaceSums> own = sums_of(sums, tiles.tiling(), number, tile);
          ReferenceMesh::Reader reader(reference_, looks_a_fitted_face * tile.faces.size());
          const FittedVertices done = fit_vertices(
              tile.positions, tile.faces, own, tile.locked, vertex_,
              [&](std::span<const Triangle> before, std::span<const Triangle> after) {
                return farther_corners(reader, before, after, vertex_.far);
              },
              [this] { job_.progress.check_cancelled(); });
          if (!done.moved.empty()) take_positions(tile, done.moved);
          fitted = {std::move(tile.vertices), done.moved.size(), done.gain};
        },
        [&](std::size_t, const FittedTile& fitted) {
          pass.vertices->append(fitted.vertices);
          pass.moved += fitted.moved;
          pass.gain += fitted.gain;
        });
    pass.vertices->finish();
    return pass;
  }

 private:
  // What a tile takes that is fitted, beside what one takes that is collapsed.
  [[nodiscard]] std::uint64_t memory_beside(const Tiles& tiles) const {
    return largest_tile(tiles.tiling(), tiles.incoming(),
                        [this](std::uint64_t vertices, std::uint64_t faces) {
                          const std::uint64_t fitted = fitted_tile_memory(vertices, faces);
                          return fitted - std::min(fitted, tile_memory(settings_, vertices, faces));
                        });
  }

  Job& job_;
  SampledSurface& samples_;
  const ReferenceMesh& reference_;
  const RefineSettings& settings_;
  const RefineMemory& memory_;
  VertexFitSettings vertex_;
};

}  // namespace

std::unique_ptr<VertexIndex> fit(Job& job, StoredMesh& mesh, const Samples& samples,
                                 const FitSettings& how, const ReferenceMesh& reference,
                                 const RefineSettings& settings, const RefineMemory& memory,
                                 FitReport& report) {
  SampledSurface surface(samples, reference.mesh(), mesh.face_count);
  Fitting fitting(job, surface, samples.single, how.boundaries, reference, settings, memory);
  report = {};
  std::unique_ptr<VertexIndex> old;
  for (; report.passes < how.passes; ++report.passes) {
    Pass pass = fitting.once(mesh);
    std::swap(mesh.vertices, pass.vertices);
    report.moved += pass.moved;
    report.rms_after = rms_of(pass.samples, pass.gain);
    if (report.passes > 0) continue;
    old = std::move(pass.vertices);
    report.samples = pass.samples.count;
    report.rms_before = rms_of(pass.samples);
  }
  return old;
}

}  // namespace winnow
