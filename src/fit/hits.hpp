// Where samples of the original meet the result, and what they sum up to at each of its faces.
#pragma once

#include "fit/face_sums.hpp"
#include "fit/samples.hpp"
#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"

#include <cstdint>

namespace winnow {

// What samples say of a whole result.
struct SampleSums {
  std::uint64_t count = 0;  // of samples that are near a face
  double squares = 0;       // of their distances
  double largest = 0;       // of their distances
};

// Looks for the face that is nearest to each sample and appends the sums of each face to `out`, in
// the order of faces. Samples that are farther off than two faces are long stand for something that
// went and are left out. Inside the job's arena. `memory` of the budget is used while it runs,
// beside what `out` takes.
SampleSums sum_up_samples(Job& job, const StoredMesh& mesh, SampledSurface& samples,
                          std::uint64_t memory, Spool& out);

}  // namespace winnow
