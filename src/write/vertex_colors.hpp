// The colour among the attributes of vertices, for formats that have a form of their own for it.
#pragma once

#include "write/mesh_encoder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace winnow {

// Whether it is one of those that VertexColors finds.
bool is_color_component(const Attribute& attribute);

class VertexColors {
 public:
  explicit VertexColors(std::span<const Attribute> attributes);

  // Whether there is any component but alpha.
  [[nodiscard]] bool any() const { return place_[0] || place_[1] || place_[2]; }
  [[nodiscard]] bool alpha() const { return place_[3].has_value(); }
  // Whether all components are whole numbers from 0 to 255.
  [[nodiscard]] bool bytes() const { return bytes_; }

  // Red, green, blue or alpha, from 0 to 1, as sRGB has it (which finish_attributes() makes of
  // light). What is missing is 0, alpha 1; what is not finite is 0; what is beyond is clipped.
  [[nodiscard]] double component(const MeshVertex& vertex, std::size_t number) const {
    if (!place_[number]) return number == 3 ? 1 : 0;
    const double stored = vertex.attributes[*place_[number]];
    return std::isfinite(stored) ? std::clamp(stored / full_[number], 0.0, 1.0) : 0;
  }
  // The first three, in the digits of floats.
  [[nodiscard]] std::array<float, 3> rgb(const MeshVertex& vertex) const {
    return {static_cast<float>(component(vertex, 0)), static_cast<float>(component(vertex, 1)),
            static_cast<float>(component(vertex, 2))};
  }

 private:
  std::array<std::optional<std::size_t>, 4> place_;
  std::array<double, 4> full_{};
  bool bytes_ = true;
};

// MeshEncoder::attribute_refusal() of formats that hold normals and, of attributes, colours; with
// one, also its `alpha`, or not.
std::string refusal_but_for_colors(const Attribute& attribute, std::span<const Attribute> wanted,
                                   bool alpha);

}  // namespace winnow
