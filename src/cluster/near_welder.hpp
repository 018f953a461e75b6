// Vertices that are nearer to each other than a distance, as one.
#pragma once

#include "cluster/near_positions.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"

#include <cstdint>
#include <memory>

namespace winnow {

// A mesh as `reader` gives it, but for the positions of some vertices: those nearer to each other
// than `distance` stand where one of them does, and so do chains of such vertices. It is the first
// in the order of the Welder's keys. Vertices are the corners of good faces, whatever the format.
// Positions are compared as they are stored. A face that loses a corner thereby has the status
// `cropped`, and is counted. Faces are not counted before they are read.
class NearWeldedReader : public MeshReader {
 public:
  virtual MeshReader& unwelded() = 0;                         // the same mesh as it was
  [[nodiscard]] virtual std::uint64_t merged() const = 0;     // positions that moved to another
  [[nodiscard]] virtual std::uint64_t collapsed() const = 0;  // faces of the last pass
};

// Reads all faces once, and all positions once, before it returns. `reader` has to allow that.
std::unique_ptr<NearWeldedReader> weld_near(Job& job, std::unique_ptr<MeshReader> reader,
                                            double distance, const NearWeldMemory& memory);

}  // namespace winnow
