#include "base/morph_clip.hpp"

namespace winnow {

MorphClip one_after_another(std::uint64_t targets) {
  constexpr float frames_per_second = 24;
  MorphClip clip;
  for (std::uint64_t t = 0; t <= targets; ++t) {
    clip.times.push_back(static_cast<float>(t) / frames_per_second);
    if (t == 0) continue;
    clip.places.push_back(static_cast<std::uint32_t>(t * targets + t - 1));
    clip.weights.push_back(1);
  }
  return clip;
}

}  // namespace winnow
