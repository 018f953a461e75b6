#include "read/gltf/scene.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace winnow {

namespace {

struct Node {
  std::optional<std::size_t> mesh;
  GltfTransform transform = gltf_identity;
  std::optional<GltfInstances> instances;
  std::vector<std::size_t> children;
};

GltfTransform transform_of(const GltfJson& json, const GltfJson::Value& node) {
  GltfTransform result = gltf_identity;
  if (const auto matrix = json.numbers<16>(node, "matrix")) {  // column after column
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column)
        result[row][column] = (*matrix)[4 * column + row];
    }
    return result;
  }
  return gltf_transform(
      json.numbers<3>(node, "translation").value_or(Point{}),
      json.numbers<4>(node, "rotation").value_or(std::array<double, 4>{0, 0, 0, 1}),
      json.numbers<3>(node, "scale").value_or(Point{1, 1, 1}));
}

std::optional<GltfInstances> instances_of(const GltfJson& json, const GltfJson::Value& node,
                                          std::size_t accessors) {
  const GltfJson::Value& extension =
      json.member(json.member(node, "extensions"), "EXT_mesh_gpu_instancing");
  const GltfJson::Value& attributes = json.member(extension, "attributes");
  const auto accessor = [&](const char* key) -> std::optional<std::size_t> {
    const GltfJson::Value& value = GltfJson::find(attributes, key);
    if (value.is_null()) return {};
    return json.index_into(value, key, accessors);
  };
  const GltfInstances instances{accessor("TRANSLATION"), accessor("ROTATION"), accessor("SCALE")};
  if (!instances.translations && !instances.rotations && !instances.scales) return {};
  return instances;
}

std::vector<Node> nodes_of(const GltfJson& json, std::size_t meshes, std::size_t accessors) {
  std::vector<Node> nodes;
  const GltfJson::Value& list = json.list("nodes");
  for (const GltfJson::Value& value : list) {
    json.check_object(value, "nodes");
    Node& node = nodes.emplace_back();
    const GltfJson::Value& mesh = GltfJson::find(value, "mesh");
    if (!mesh.is_null()) node.mesh = json.index_into(mesh, "mesh", meshes);
    node.transform = transform_of(json, value);
    node.instances = instances_of(json, value, accessors);
    for (const GltfJson::Value& child : json.list(value, "children"))
      node.children.push_back(json.index_into(child, "children", list.size()));
  }
  return nodes;
}

std::vector<std::size_t> roots_of(const GltfJson& json, const std::vector<Node>& nodes) {
  std::vector<std::size_t> found;
  const GltfJson::Value& scenes = json.list("scenes");
  if (!scenes.empty()) {
    const GltfJson::Value& chosen = GltfJson::find(json.root(), "scene");
    const std::size_t scene =
        chosen.is_null() ? 0 : json.index_into(chosen, "scene", scenes.size());
    json.check_object(scenes[scene], "scenes");
    for (const GltfJson::Value& node : json.list(scenes[scene], "nodes"))
      found.push_back(json.index_into(node, "nodes", nodes.size()));
    return found;
  }
  std::vector<bool> child(nodes.size());
  for (const Node& node : nodes) {
    for (const std::size_t one : node.children) child[one] = true;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!child[i]) found.push_back(i);
  }
  return found;
}

}  // namespace

std::vector<GltfPlacedMesh> place_meshes(const GltfJson& json, std::size_t meshes,
                                         std::size_t accessors, const Point& center) {
  std::vector<GltfPlacedMesh> placed;
  const GltfTransform to_center = gltf_transform(center, {0, 0, 0, 1}, {1, 1, 1});
  const std::vector<Node> nodes = nodes_of(json, meshes, accessors);
  if (nodes.empty()) {
    for (std::size_t i = 0; i < meshes; ++i) placed.push_back({i, to_center, {}, 0});
    return placed;
  }
  struct Waiting {
    std::size_t node;
    GltfTransform parent;
  };
  std::vector<Waiting> waiting;
  const std::vector<std::size_t> first = roots_of(json, nodes);
  std::vector<bool> seen(nodes.size());
  const auto visit = [&](std::size_t node, const GltfTransform& parent) {
    if (seen[node])
      json.fail("node " + std::to_string(node) + " has more than one parent, or is its own");
    seen[node] = true;
    waiting.push_back({node, parent});
  };
  for (auto root = first.rbegin(); root != first.rend(); ++root) visit(*root, to_center);
  while (!waiting.empty()) {
    const Waiting next = waiting.back();
    waiting.pop_back();
    const Node& node = nodes[next.node];
    const GltfTransform to_world = next.parent * node.transform;
    if (node.mesh) placed.push_back({*node.mesh, to_world, node.instances, next.node});
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      visit(*child, to_world);
  }
  return placed;
}

}  // namespace winnow
