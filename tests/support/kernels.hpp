// The corner kernels, called directly.
#pragma once

#include "cluster/grid.hpp"
#include "cluster/kernel/corner_kernel.hpp"
#include "read/face_batch.hpp"
#include "support/runnable.hpp"
#include "support/surfaces.hpp"

#include <memory>
#include <vector>

namespace winnow::test {

inline auto runnable_kernels() {
  return runnable(WINNOW_KERNELS(corner_kernel));
}

// What the kernel makes of at most kernel_capacity faces.
inline std::unique_ptr<CornerSums> kernel_sums(CornerKernel kernel,
                                               const std::vector<Triangle>& faces, const Grid& grid,
                                               bool single = false) {
  const auto batch = std::make_unique<FaceBatch>();
  KernelInput input{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Beyond the last face there may be anything.
      batch->position[corner][axis].fill(-3e300);
      batch->single_position[corner][axis].fill(-3e30F);
      for (std::size_t i = 0; i < faces.size(); ++i) {
        batch->position[corner][axis].at(i) = faces[i][corner][axis];
        batch->single_position[corner][axis].at(i) = static_cast<float>(faces[i][corner][axis]);
      }
      input.position[corner][axis] = batch->position[corner][axis].data();
      input.single_position[corner][axis] = batch->single_position[corner][axis].data();
    }
  }
  input.single = single;
  input.count = faces.size();
  for (std::size_t axis = 0; axis < 3; ++axis) input.origin[axis] = grid.origin[axis];
  input.inverse = grid.inverse;
  input.quadrics = true;
  input.sides = true;
  auto out = std::make_unique<CornerSums>();
  kernel(input, *out);
  return out;
}

// A lattice whose cells are units of length.
inline Grid unit_grid(const Point& origin = {0, 0, 0}) {
  return {origin, 1, 1};
}

}  // namespace winnow::test
