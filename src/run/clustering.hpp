// The first half of the pipeline: the input as a clustered or welded mesh, as fine as the options
// ask for.
#pragma once

#include <winnow/simplify.hpp>

#include "cluster/cell_search.hpp"
#include "cluster/clusterer.hpp"
#include "cluster/resolution.hpp"
#include "fit/samples.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"
#include "run/attributes.hpp"
#include "run/plan.hpp"
#include "run/safe_clustering.hpp"
#include "stitch/level_goal.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace winnow {

// What all that comes after has to know of it.
struct Clustered {
  StoredMesh mesh;
  std::vector<LevelGoal> goals{};       // of each target, the finest first
  bool normals = false;                 // of the input
  bool double_positions = false;        // likewise
  std::vector<Attribute> attributes{};  // that vertices carry
  Samples samples{};                    // of the input, where the result is going to be fitted
  SimplifyReport report{};              // of the input, its attributes and the cells
  std::unique_ptr<Spool> map{};  // of each vertex of the input a Destination; only if asked for
};

inline constexpr const char* clustering_alone = "clustering alone was asked for";

class Clustering {
 public:
  // `joined`: `weld` moved vertices.
  Clustering(Job& job, MeshReader& reader, const SimplifyOptions& options,
             TakenAttributes attributes, const MemoryPlan& plan, bool joined);

  // The mesh that is written, or, if it is going to be refined, what that starts from. Once.
  Clustered run();

  // Where the vertices of the input went, which became this; `unwelded`: the reader before anything
  // was welded.
  std::unique_ptr<Spool> map(MeshReader& unwelded, const Clustered& clustered);

 private:
  StoredMesh as_asked();
  Grid grid_of_cell();
  Grid grid_of_box();
  StoredMesh to_error();
  StoredMesh to_detail();
  CellCounts sample(std::uint64_t target);
  ClusterResult to_count(const CellCounts& sample, std::uint64_t target, double tolerated);
  void note_missed_count(const CellSearch& search, std::uint64_t faces, std::uint64_t target);
  ClusterResult once();
  std::optional<SafeMesh> safely(const Box& box, ClusterResult coarse);
  StoredMesh welded(const std::string& reason);  // why nothing is clustered
  Samples samples();
  void take_counts(const ClusterCounts& counts);
  [[noreturn]] void refuse_empty() const;
  StoredMesh reported(ClusterResult clustered);
  [[noreturn]] void refuse_result(const ClusterResult& clustered) const;

  Job& job_;
  MeshReader& reader_;
  const SimplifyOptions& options_;
  const MemoryPlan& plan_;
  bool joined_;
  SimplifyReport report_;
  Stopwatch watch_;
  ClusterSettings settings_;
  std::uint64_t available_ = 0;  // faces of the input
  std::uint64_t target_ = 0;
  double error_ = 0;
  std::vector<LevelGoal> goals_;
  std::unique_ptr<Spool> open_cells_;  // of the last pass; null where boundaries may move
  std::optional<Grid> lattice_;        // of welded vertices
  std::optional<SplitCells> cells_;    // of clustered ones, where some were split
  unsigned shift_ = 0;                 // see SafeMesh
};

}  // namespace winnow
