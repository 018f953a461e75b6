// How a mesh with morph targets plays: the weights of its targets over time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace winnow {

struct MorphClip {
  enum class Between : std::uint8_t { linear, step, cubic };  // what weights are between two times

  std::string name;
  Between between = Between::linear;
  std::vector<float> times;  // in seconds, ascending
  // At each time one weight of each target, with `cubic` three. Those that are not 0, by their
  // place among all, ascending.
  std::vector<std::uint32_t> places;
  std::vector<float> weights;

  [[nodiscard]] std::uint64_t rows() const {
    return times.size() * (between == Between::cubic ? 3 : 1);
  }
};

// Goes from the mesh to its first target, and on to each next one, at 24 frames a second.
MorphClip one_after_another(std::uint64_t targets);

}  // namespace winnow
