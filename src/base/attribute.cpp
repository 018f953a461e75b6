#include "base/attribute.hpp"

#include "base/srgb.hpp"

namespace winnow {

std::vector<ScalarType> types_of(std::span<const Attribute> attributes) {
  std::vector<ScalarType> types;
  for (const Attribute& attribute : attributes) types.push_back(attribute.type);
  return types;
}

double full_component(ScalarType type) {
  if (type == ScalarType::uint8) return 255;
  return type == ScalarType::uint16 ? 65535 : 1;
}

double mean_of_stored(const Attribute& attribute, double stored) {
  if (!is_color(attribute)) return stored;
  const double component = stored / full_component(attribute.type);
  return attribute.kind == AttributeKind::light ? component : light_of_component(component);
}

double stored_of_mean(const Attribute& attribute, double mean) {
  if (!is_color(attribute)) return mean;
  return component_of_light(mean) * full_component(attribute.type);
}

std::string described(const Attribute& attribute) {
  return attribute.name + " (" + name_of(attribute.type) + ")";
}

}  // namespace winnow
