// Faces of a clustered mesh that lie on each other, back to back, and can go without a trace.
#pragma once

#include "base/morton.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// They stay in the mesh until it is joined with another (cluster/joined_mesh.hpp).
struct Folds {
  std::vector<std::array<std::uint32_t, 3>> faces;  // by their vertices, in ascending order
  std::vector<CellKey> vertices;                    // that have no other face, in ascending order

  [[nodiscard]] bool empty() const { return faces.empty(); }
};

// Whether a face is a fold, of faces that are asked for in the order of their lowest vertices.
class FoldedFaces {
 public:
  explicit FoldedFaces(const Folds& folds) : at_(folds.faces.begin()), end_(folds.faces.end()) {}

  bool has(const std::array<std::uint32_t, 3>& face) {
    if (at_ == end_ || face[0] < (*at_)[0]) return false;
    if ((*at_)[0] < face[0]) at_ = std::lower_bound(at_, end_, std::array{face[0], 0U, 0U});
    for (auto fold = at_; fold != end_ && (*fold)[0] == face[0]; ++fold) {
      if (*fold == face) return true;
    }
    return false;
  }

 private:
  std::vector<std::array<std::uint32_t, 3>>::const_iterator at_, end_;
};

}  // namespace winnow
