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
  if (attribute.kind != AttributeKind::color) return stored;
  return light_of_component(stored / full_component(attribute.type));
}

double stored_of_mean(const Attribute& attribute, double mean) {
  if (attribute.kind != AttributeKind::color) return mean;
  return component_of_light(mean) * full_component(attribute.type);
}

std::string described(const Attribute& attribute) {
  return attribute.name + " (" + name_of(attribute.type) + ")";
}

}  // namespace winnow
