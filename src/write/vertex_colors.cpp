#include "write/vertex_colors.hpp"

namespace winnow {

namespace {

std::optional<std::size_t> component_of(const Attribute& attribute) {
  const std::optional<std::size_t> component = component_named(attribute.name);
  if (is_color(attribute) || (component == 3 && may_be_component(attribute.type))) return component;
  return {};
}

}  // namespace

bool is_color_component(const Attribute& attribute) {
  return component_of(attribute).has_value();
}

VertexColors::VertexColors(std::span<const Attribute> attributes) {
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const std::optional<std::size_t> component = component_of(attributes[i]);
    if (!component || place_.at(*component)) continue;
    place_.at(*component) = i;
    full_.at(*component) = full_component(attributes[i]);
    bytes_ = bytes_ && attributes[i].type == NumberType::uint8;
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
