// Points of the original that a result is fitted to.
#pragma once

#include "base/vector.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"
#include "read/mesh_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

// In whatever order, in memory or in scratch: as floats where the input has those.
struct Samples {
  std::unique_ptr<Spool> points;  // three numbers each; null where there are none
  bool single = true;

  [[nodiscard]] std::size_t point_bytes() const {
    return 3 * (single ? sizeof(float) : sizeof(double));
  }
  [[nodiscard]] std::uint64_t count() const {
    return points == nullptr ? 0 : points->size() / point_bytes();
  }
  // `count` of them from `first` on.
  void read(std::uint64_t first, std::size_t count, std::vector<Point>& out) const;
};

// One pass over the faces, whose `area` is known, for a result of so many faces. The same points
// whatever the order of faces is, spread evenly.
Samples sample_faces(Job& job, MeshReader& reader, std::uint64_t wanted_faces, double area);

}  // namespace winnow
