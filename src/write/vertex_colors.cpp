#include "write/vertex_colors.hpp"

namespace winnow {

namespace {

constexpr std::array<const char*, 4> names{"red", "green", "blue", "alpha"};

std::optional<std::size_t> component_of(const Attribute& attribute) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (attribute.name != names[i]) continue;
    if (is_color(attribute)) return i;
    if (i == 3 && (!is_integer(attribute.type) || attribute.type == ScalarType::uint8 ||
                   attribute.type == ScalarType::uint16))
      return i;
  }
  return {};
}

}  // namespace

VertexColors::VertexColors(std::span<const Attribute> attributes) {
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const std::optional<std::size_t> component = component_of(attributes[i]);
    if (!component) continue;
    place_.at(*component) = i;
    full_.at(*component) = full_component(attributes[i].type);
    bytes_ = bytes_ && attributes[i].type == ScalarType::uint8;
  }
}

std::string refusal_but_for_colors(const Attribute& attribute, std::span<const Attribute> wanted,
                                   bool alpha) {
  if (attribute.kind == AttributeKind::normal) return {};
  const std::optional<std::size_t> component = component_of(attribute);
  if (component && component != 3) return {};
  if (component && alpha && VertexColors(wanted).any()) return {};
  return "the output's format holds no attributes but normals and colours:";
}

}  // namespace winnow
