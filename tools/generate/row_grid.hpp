// Surfaces made of rows of the same length.
#pragma once

#include <cstdint>

namespace winnow {

struct RowGrid {
  std::uint64_t columns = 0, rows = 0;
};

// The columns and rows whose product is nearest to `count`, among those whose proportion is near to
// `proportion` (columns / rows); the better proportion decides among equals.
RowGrid nearest_grid(std::uint64_t count, double proportion, RowGrid smallest);

// Finds the row of a number; costs a division only when the row changes.
class RowFinder {
 public:
  explicit RowFinder(std::uint64_t length) : length_(length) {}

  void find(std::uint64_t number) {
    if (number - begin_ < length_) return;
    row_ = number / length_;
    begin_ = row_ * length_;
  }
  [[nodiscard]] std::uint64_t row() const { return row_; }
  [[nodiscard]] std::uint64_t begin() const { return begin_; }  // the first number in the row

 private:
  std::uint64_t length_, row_ = 0, begin_ = 0;
};

}  // namespace winnow
