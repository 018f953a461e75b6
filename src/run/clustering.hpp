// The first half of the road: the input as a clustered or welded mesh, as fine as the options ask for.
#pragma once

#include <winnow/simplify.hpp>

#include "cluster/clusterer.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"
#include "run/plan.hpp"

#include <cstdint>

namespace winnow {

class Clustering {
 public:
  Clustering(Job& job, MeshReader& reader, const SimplifyOptions& options, CarriedAttributes attributes,
             const MemoryPlan& plan, SimplifyReport& report);

  // The mesh that is written, or, if it is going to be refined, what that starts from.
  ClusteredMesh run();

  // After run(): the faces wanted; 0 where an error says how many.
  [[nodiscard]] std::uint64_t target() const { return target_; }
  // The error wanted, in model units; 0 where faces are counted.
  [[nodiscard]] double error() const { return error_; }
  // Edge of a cell; 0 where equal positions were welded.
  [[nodiscard]] double cell() const { return settings_.grid.cell; }

 private:
  Grid grid_of_cell();
  Grid grid_of_box();
  ClusteredMesh to_error();
  ClusteredMesh to_detail();
  ClusteredMesh to_count(std::uint64_t target, double tolerated);
  ClusteredMesh once();
  ClusteredMesh welded();
  void take_counts(const ClusterCounts& counts);
  [[noreturn]] void refuse_empty() const;
  [[noreturn]] void refuse_result(const ClusteredMesh& mesh) const;

  Job& job_;
  MeshReader& reader_;
  const SimplifyOptions& options_;
  const MemoryPlan& plan_;
  SimplifyReport& report_;
  Stopwatch watch_;
  ClusterSettings settings_;
  std::uint64_t available_ = 0;  // faces of the input
  std::uint64_t target_ = 0;
  double error_ = 0;
};

}  // namespace winnow
