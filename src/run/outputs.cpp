#include "run/outputs.hpp"

#include <vector>

namespace winnow {

void finish(const Outputs& outputs) {
  std::vector<Output*> all;
  for (const auto& map : outputs.maps) all.push_back(map.get());
  for (const auto& mesh : outputs.meshes) all.push_back(mesh.get());
  if (all.size() == 1) return all.front()->finish();
  std::size_t finished = 0;
  try {
    for (; finished < all.size(); ++finished) all[finished]->finish_for_now();
  } catch (...) {
    while (finished > 0) all[--finished]->take_back();
    throw;
  }
}

}  // namespace winnow
