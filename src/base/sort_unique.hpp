// A list as a set.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace winnow {

// In ascending order, each once. `before` is the ascending order, and may do more.
template <typename T, typename Before = std::less<>>
void sort_unique(std::vector<T>& values, Before before = {}) {
  std::sort(values.begin(), values.end(), before);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace winnow
