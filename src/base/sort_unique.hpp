// A list as a set.
#pragma once

#include <algorithm>
#include <vector>

namespace winnow {

// In ascending order, each once.
template <typename T>
void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace winnow
