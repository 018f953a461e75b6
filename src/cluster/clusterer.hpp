// The station that turns faces into cells and the faces between them.
#pragma once

#include <winnow/simplify.hpp>

#include "base/attribute.hpp"
#include "cluster/folds.hpp"
#include "cluster/grid.hpp"
#include "cluster/split_cells.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"
#include "mesh/stored_mesh.hpp"
#include "read/face_batch.hpp"
#include "read/good_faces.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace winnow {

// How the budget is divided here. Parts of it are used one after the other.
struct ClusterMemory {
  std::uint64_t table = 0;     // cells
  std::uint64_t faces = 0;     // faces between cells, all threads together
  std::uint64_t vertices = 0;  // vertices of the result
  std::uint64_t result = 0;    // faces of the result
  std::size_t table_parts = 16;
  std::uint64_t attributes = 0;  // of cells, or of welded vertices

  // What one thread needs besides, whatever the budget.
  static std::uint64_t per_thread(bool quadrics);
  // The least that `table` and `faces` can be.
  static std::uint64_t smallest_table(std::size_t parts, bool quadrics);
  static constexpr std::uint64_t smallest_faces_per_thread = std::uint64_t{2} << 20;
};

struct ClusterCounts {
  std::uint64_t faces = 0;
  BadFaces bad;
  std::uint64_t cropped = 0;
  std::uint64_t clamped = 0;
  FirstBad first_bad;
  // The farthest finite corner outside of the lattice, in cells from its middle; 0 where there is
  // none.
  double outside = 0;

  void add(const ClusterCounts& other);
};

// A face of the result, and how many faces fell onto it: so many of its sense, and of the other.
struct FusedFace {
  FaceVertices vertices{};
  std::uint32_t along = 0, against = 0;
};

// The mesh of cells, and what was found on the way.
struct ClusterResult {
  StoredMesh mesh;
  std::uint64_t cells = 0;
  std::uint64_t turned = 0;
  std::uint64_t fused = 0;  // pairs of opposite faces that left one face
  // Only where clustered for refinement: the faces that several fell onto, a FusedFace each, in the
  // order of faces; and the keys of cells that no face of three cells touches, in ascending order.
  std::unique_ptr<Spool> several{};
  std::unique_ptr<Spool> vanished{};
  Folds folds{};
};

struct ClusterSettings {
  Grid grid;
  Placement placement = Placement::mean;
  bool double_positions = false;  // round positions to float otherwise
  // Faces keep the windings that they inherit: every edge of a closed surface is still passed once
  // in either direction.
  bool for_refinement = false;
  // Whether vertices at boundaries are placed on them. Not where cells at boundaries are split, and
  // not by the mean, which is for speed.
  [[nodiscard]] bool keeps_boundaries() const {
    return !for_refinement && placement == Placement::quadric;
  }
  bool keep_quadrics = false;  // of the cells, as state; with Placement::quadric
  [[nodiscard]] MeshLayout layout() const;
  CarriedAttributes attributes{};
  const SplitCells* split = nullptr;  // cells are named by it; none where it is null
};

class Clusterer {
 public:
  static std::unique_ptr<Clusterer> make(Job& job, const ClusterSettings& settings,
                                         const ClusterMemory& memory);
  virtual ~Clusterer() = default;

  // From any thread of the arena the job runs in.
  virtual void add(const FaceBatch& faces) = 0;
  // A face that is known by its three cells alone. It gives them no position.
  virtual void add(const std::array<CellKey, 3>& cells) = 0;

  // Between batches, when no add() is running.
  [[nodiscard]] virtual bool wants_to_spill() const = 0;
  virtual void spill() = 0;
  virtual ClusterCounts counts() = 0;

  // Builds the mesh; the last call.
  virtual ClusterResult finish() = 0;
};

}  // namespace winnow
