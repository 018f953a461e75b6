// What the vertices of a glTF's scene carry.
//
// COLOR_0 is light, by the specification: a factor of the base colour, which is linear. It is kept
// as the file has it and called AttributeKind::light, so that eight bits of it stay what they are;
// what is written as a colour (PLY, OBJ, OFF) is encoded as sRGB then.
#pragma once

#include "read/attribute_choice.hpp"
#include "read/gltf/accessor.hpp"
#include "read/gltf/document.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// Of all primitives in the scene together.
struct GltfAttributes {
  // Normals and colours, where all primitives have them. Colours are of the widest type that any
  // has, and have an alpha if any has.
  bool normals = false, colors = false, alpha = false;
  NumberType color_type = NumberType::uint8;
  std::vector<std::string> unread;  // in words
};
GltfAttributes attributes_of(const GltfDocument& document);

// nx, ny and nz as floats; red, green, blue and alpha.
AvailableAttributes offer_of(const GltfAttributes& attributes);

// The numbers of what is offered, primitive by primitive.
class GltfVertexAttributes {
 public:
  // `carried`: of each attribute that is offered whether it is wanted. `moves`: what is added.
  GltfVertexAttributes(GltfBytes& bytes, const GltfDocument& document,
                       const GltfAttributes& attributes, const GltfPrimitive& primitive,
                       const GltfPrimitive::Target& moves, const std::vector<bool>& carried,
                       const GltfTurn& turn, const std::string& name);

  // What the next `count` vertices carry, vertex by vertex, into `out`: as many as the next() of
  // other accessors gives.
  void next(std::size_t count, std::vector<double>& out);

 private:
  [[nodiscard]] bool any(std::size_t begin, std::size_t end) const;
  // A component of a colour, which is `at_rest` without what a target adds.
  [[nodiscard]] double moved(std::size_t vertex, std::size_t component, double at_rest,
                             double full) const;

  const GltfAttributes& attributes_;
  const std::vector<bool>& carried_;
  const GltfTurn& turn_;
  std::size_t first_color_;  // among what is offered
  std::optional<GltfElements> normals_, normal_moves_, colors_, color_moves_;
  std::span<const double> moves_;  // of the colours of the part at hand
};

}  // namespace winnow
