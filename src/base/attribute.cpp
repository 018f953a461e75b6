#include "base/attribute.hpp"

#include "base/srgb.hpp"

#include <algorithm>

namespace winnow {

std::vector<NumberType> types_of(std::span<const Attribute> attributes) {
  std::vector<NumberType> types;
  for (const Attribute& attribute : attributes) types.push_back(attribute.type);
  return types;
}

std::optional<std::size_t> component_named(std::string_view name) {
  using Names = std::array<std::string_view, 4>;
  constexpr std::array<Names, 3> all{
      Names{"red", "green", "blue", "alpha"},
      Names{"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
      Names{"r", "g", "b", "a"}};
  for (const Names& names : all) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  }
  return {};
}

double full_component(NumberType type) {
  if (type == NumberType::uint8) return 255;
  return type == NumberType::uint16 ? 65535 : 1;
}

double full_component(const Attribute& attribute) {
  return attribute.full > 0 ? attribute.full : full_component(attribute.type);
}

double mean_of_stored(const Attribute& attribute, double stored) {
  if (!is_color(attribute)) return stored;
  const double component = stored / full_component(attribute);
  if (attribute.kind == AttributeKind::light) return component;
  return light_of_component(std::min(component, 1.0));
}

double stored_of_mean(const Attribute& attribute, double mean) {
  if (!is_color(attribute)) return mean;
  return component_of_light(mean) * full_component(attribute);
}

std::string described(const Attribute& attribute) {
  return attribute.name + " (" + name_of(attribute.type) + ")";
}

}  // namespace winnow
