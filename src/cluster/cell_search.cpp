#include "cluster/cell_search.hpp"

#include "base/logarithm.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

// Cells that differ by less give the same faces, but for noise.
constexpr double same_cell = 1e-3;
}  // namespace

CellSearch::CellSearch(const CellCounts& sample, double wanted_faces)
    : sample_(sample), wanted_(wanted_faces), next_(sample.cell_for(wanted_faces)) {}

void CellSearch::add(double cell, std::uint64_t count) {
  const auto faces = static_cast<double>(count);
  // A miss by a factor counts the same up and down.
  const double miss = faces == 0 ? HUGE_VAL : std::max(faces / wanted_, wanted_ / faces);
  // Of cells that left nothing, the last is the smallest.
  if (best_cell_ == 0 || miss < best_miss_ || best_miss_ == HUGE_VAL) {
    best_cell_ = cell;
    best_miss_ = miss;
  }
  const double least = sample_.smallest_cell();
  finest_ |= cell <= least * (1 + same_cell);
  if (faces > wanted_) {
    if (!too_many_ || cell > too_many_->cell) too_many_ = {cell, faces};
  } else {
    if (!too_few_ || cell < too_few_->cell) too_few_ = {cell, faces};
  }
  if (too_many_ && too_few_) {
    next_ = between();
    // Where a coarser cell gave more faces there is nothing between the two.
    exhausted_ = !(too_few_->cell > too_many_->cell * (1 + same_cell));
  } else if (count == 0) {
    next_ = std::max(least, cell / smaller_by_);
    smaller_by_ *= smaller_by_;
    exhausted_ = next_ >= cell;
  } else {
    next_ = sample_.cell_for(sample_.expected_faces(cell) / (faces / wanted_));
    exhausted_ = std::abs(next_ / cell - 1) < same_cell;
  }
}

// On the straight line through both in logarithms; well inside, so that each try takes away a part.
double CellSearch::between() const {
  const double fine = natural_logarithm(too_many_->cell);
  const double coarse = natural_logarithm(too_few_->cell);
  const double most = natural_logarithm(too_many_->faces);
  const double least = natural_logarithm(std::max(1.0, too_few_->faces));
  const double part = (most - natural_logarithm(wanted_)) / (most - least);
  const double inside = std::clamp(part, 0.1, 0.9);
  return too_many_->cell * exponential(inside * (coarse - fine));
}

}  // namespace winnow
