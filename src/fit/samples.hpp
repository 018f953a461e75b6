// Points of the original that a result is fitted to.
#pragma once

#include "base/vector.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"
#include "mesh/stored_mesh.hpp"
#include "read/mesh_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace winnow {

// What is kept of the original where a result is going to be fitted to it.
struct Samples {
  // In whatever order, three numbers each: as floats where the input has those. Null where all
  // faces were welded: then the mesh before the first round is the original.
  std::unique_ptr<Spool> points;
  bool single = true;
  double area = 0;  // of the original; 0 where nothing is going to be fitted

  [[nodiscard]] std::size_t point_bytes() const {
    return 3 * (single ? sizeof(float) : sizeof(double));
  }
};

// One pass over the faces, whose `area` is known, for a result of so many faces. The same points
// whatever the order of faces is, spread evenly.
Samples sample_faces(Job& job, MeshReader& reader, std::uint64_t wanted_faces, double area);

// The points, block by block.
class SampledSurface {
 public:
  // For a result of so many faces. `original`: the mesh before the first round. Both must stay.
  SampledSurface(const Samples& samples, const StoredMesh& original, std::uint64_t wanted_faces);

  // Takes so many bytes for each block that is read at once, at least and at most.
  static constexpr std::uint64_t least_memory = std::uint64_t{1} << 18;
  static constexpr std::uint64_t most_memory = std::uint64_t{3} << 19;
  void use(std::uint64_t memory);

  [[nodiscard]] std::uint64_t expected() const;  // about so many
  [[nodiscard]] std::uint64_t most() const;
  [[nodiscard]] std::uint64_t blocks() const;

  // Parts of the block `number`; points that follow each other are mostly close.
  using Each = std::function<void(std::span<const Point>)>;
  void for_each_part(std::uint64_t number, const Each& each) const;

 private:
  const Samples& samples_;
  const StoredMesh& original_;
  double density_;
  std::uint64_t block_;  // faces of the mesh, or points that were kept
};

}  // namespace winnow
