// The area of all good faces that pass by, whatever their order.
#pragma once

#include "base/exact_sum.hpp"
#include "base/per_slot.hpp"
#include "cluster/kernel/area_kernel.hpp"
#include "read/face_batch.hpp"

#include <cstdint>

namespace winnow {

class AreaSum {
 public:
  // Each face's area is rounded to a 2^-40th of `unit`, which costs next to nothing to add up.
  // Faces larger than 2^8 units, or all where `unit` is 0, are added up exactly.
  AreaSum(unsigned threads, double unit);

  void add(const FaceBatch& faces);  // from any thread of the job's arena
  [[nodiscard]] double value() const;

 private:
  struct Part {
    std::int64_t units = 0;  // 2^-40ths; at most 2^48 a face, moved to `large` in time
    ExactSum large;
  };

  const AreaKernel& kernel_;
  double scale_;  // 2^40 / unit
  PerSlot<Part> parts_;
};

}  // namespace winnow
