// What the samples of a face say of where its corners should be.
#pragma once

#include <array>
#include <cstddef>

namespace winnow {

// Sums over the samples that are nearest to a face. Each stands at three weights of the corners,
// which are 1 together, and its way leads from there to the sample.
struct FaceSums {
  std::array<float, 6> products{};             // of two weights: 00, 11, 22, 01, 12, 20
  std::array<std::array<float, 3>, 3> pull{};  // of each corner, of weight times way
  float farthest = 0;                          // the largest of the ways' squared lengths

  // The sum of products of the weights of two corners.
  [[nodiscard]] double product(std::size_t i, std::size_t k) const {
    if (i == k) return static_cast<double>(products[i]);
    return static_cast<double>(products[i + k == 2 ? 5 : 2 + i + k]);
  }
  // How many samples there are, except for rounding.
  [[nodiscard]] double count() const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += static_cast<double>(products[i]);
    for (std::size_t i = 3; i < 6; ++i) sum += 2 * static_cast<double>(products[i]);
    return sum;
  }
};

}  // namespace winnow
