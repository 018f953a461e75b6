// The faces that join three cells, or three vertices: kept by each thread for itself, sorted,
// counted once.
#pragma once

#include "cluster/cell_sum.hpp"
#include "io/sorted_list.hpp"

#include <utility>

namespace winnow {

using FaceList = SortedList<CellFace>;

// Of three different cells, in the order of the face's corners.
inline CellFace cell_face(CellKey a, CellKey b, CellKey c) {
  // Each exchange mirrors the face.
  bool along = true;
  const auto order = [&along](CellKey& low, CellKey& high) {
    if (high < low) {
      std::swap(low, high);
      along = !along;
    }
  };
  order(a, b);
  order(b, c);
  order(a, b);
  return {{a, b, c}, along ? 1U : 0U, along ? 0U : 1U};
}

}  // namespace winnow
