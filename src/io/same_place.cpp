#include "io/same_place.hpp"

#include <filesystem>

namespace winnow {

bool same_place(const std::string& one, const std::string& other) {
  if (one.empty() || other.empty()) return false;
  std::error_code ignored;
  return one == other || std::filesystem::weakly_canonical(one, ignored) ==
                             std::filesystem::weakly_canonical(other, ignored);
}

}  // namespace winnow
