#include "run/mesh_facts.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace winnow {

namespace {

constexpr const char* goal_count = "clustered.goals";
constexpr const char* attribute_count = "clustered.attributes";

std::string goal_key(std::size_t number, const char* what) {
  return std::string(goal_count) + "." + std::to_string(number) + "." + what;
}

std::string attribute_key(std::size_t number, const char* what) {
  return std::string(attribute_count) + "." + std::to_string(number) + "." + what;
}

}  // namespace

void put(Manifest& manifest, const MeshFacts& facts) {
  manifest.set(goal_count, std::uint64_t{facts.goals.size()});
  for (std::size_t i = 0; i < facts.goals.size(); ++i) {
    manifest.set(goal_key(i, "faces"), facts.goals[i].faces);
    manifest.set(goal_key(i, "error"), facts.goals[i].error);
  }
  manifest.set("clustered.normals", std::uint64_t{facts.normals});
  manifest.set("clustered.double_positions", std::uint64_t{facts.double_positions});
  manifest.set(attribute_count, std::uint64_t{facts.attributes.size()});
  for (std::size_t i = 0; i < facts.attributes.size(); ++i) {
    const Attribute& attribute = facts.attributes[i];
    manifest.set(attribute_key(i, "name"), attribute.name);
    manifest.set(attribute_key(i, "type"), static_cast<std::uint64_t>(attribute.type));
    manifest.set(attribute_key(i, "kind"), static_cast<std::uint64_t>(attribute.kind));
    manifest.set(attribute_key(i, "full"), attribute.full);
    if (attribute.no_data) manifest.set(attribute_key(i, "no_data"), *attribute.no_data);
  }
}

bool holds_facts(const Manifest& manifest) {
  return manifest.has(goal_count);
}

MeshFacts facts_in(const Manifest& manifest) {
  MeshFacts facts;
  for (std::size_t i = 0; i < manifest.number(goal_count); ++i)
    facts.goals.push_back(
        {manifest.number(goal_key(i, "faces")), manifest.real(goal_key(i, "error"))});
  facts.normals = manifest.number("clustered.normals") != 0;
  facts.double_positions = manifest.number("clustered.double_positions") != 0;
  for (std::size_t i = 0; i < manifest.number(attribute_count); ++i) {
    Attribute& attribute = facts.attributes.emplace_back();
    attribute.name = manifest.text(attribute_key(i, "name"));
    attribute.type = static_cast<NumberType>(manifest.number(attribute_key(i, "type")));
    attribute.kind = static_cast<AttributeKind>(manifest.number(attribute_key(i, "kind")));
    attribute.full = manifest.real(attribute_key(i, "full"));
    if (manifest.has(attribute_key(i, "no_data")))
      attribute.no_data = manifest.real(attribute_key(i, "no_data"));
  }
  return facts;
}

}  // namespace winnow
