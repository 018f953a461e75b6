// What a comparison reports of each mesh by itself.
#pragma once

#include <winnow/compare.hpp>

#include "base/per_slot.hpp"
#include "io/job.hpp"
#include "measure/surface_totals.hpp"
#include "read/good_faces.hpp"

namespace winnow {

class FaceIntake {
 public:
  // Volumes are seen from `origin`, any point near the surface. Inside the job's arena.
  FaceIntake(Job& job, const Point& origin);

  void add(const GoodFaces& faces);  // from any thread

  // When all faces were added.
  void finish();
  [[nodiscard]] const SurfaceTotals& totals() const { return all_.totals; }
  void report(CompareReport::Mesh& mesh) const;  // everything but `samples`

 private:
  struct Part {
    explicit Part(const Point& origin) : totals(origin) {}
    SurfaceTotals totals;
    BadFaces bad;
  };

  PerSlot<Part> parts_;
  Part all_;
};

}  // namespace winnow
