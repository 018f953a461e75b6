// Meshes in memory, and the files of the same content.
#pragma once

#include <winnow/mesh.hpp>

#include "base/number_type.hpp"
#include "support/surfaces.hpp"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace winnow::test {

// A ball of about 4 n^2 faces whose vertices carry a colour, a label and a measurement.
inline Mesh ball_arrays(std::size_t n, bool doubles, bool attributes) {
  Mesh mesh;
  std::vector<double> positions;
  std::map<Point, std::uint32_t> numbers;
  for (const Triangle& face : as_floats(ball(n, 0.1))) {
    for (const Point& corner : face) {
      const auto next = static_cast<std::uint32_t>(positions.size() / 3);
      const auto [at, is_new] = numbers.emplace(corner, next);
      if (is_new) positions.insert(positions.end(), corner.begin(), corner.end());
      mesh.faces.push_back(at->second);
    }
  }
  if (attributes) {
    std::vector<std::uint8_t> red;
    std::vector<std::uint8_t> green;
    std::vector<std::int32_t> label;
    std::vector<double> heat;
    for (std::size_t i = 0; i < positions.size(); i += 3) {
      red.push_back(static_cast<std::uint8_t>(100 * (positions[i] + 1.2)));
      green.push_back(static_cast<std::uint8_t>(i % 251));
      label.push_back(positions[i + 1] < 0 ? -7 : 70'000);
      heat.push_back(positions[i + 2] / 3);
    }
    mesh.attributes = {
        {"red", red}, {"green", green}, {"blue", green}, {"label", label}, {"heat", heat}};
  }
  if (doubles) {
    for (double& coordinate : positions) coordinate += 1e-9;
    mesh.positions = positions;
  } else {
    mesh.positions = std::vector<float>(positions.begin(), positions.end());
  }
  return mesh;
}

// A binary PLY of it.
inline std::string ply_of_arrays(const Mesh& mesh, const std::string& comment = {}) {
  const auto type_name = [](const auto& values) {
    const auto type = type_of_number<std::decay_t<decltype(values[0])>>();
    const char* const names[] = {"char", "uchar", "short", "ushort", "int",
                                 "uint", "?",     "?",     "float",  "double"};
    return std::string(names[static_cast<std::size_t>(type)]);
  };
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  if (!comment.empty()) text += "comment " + comment + "\n";
  text += "element vertex " + std::to_string(mesh.vertex_count()) + "\n";
  const auto bytes_from = [](const auto& values, std::size_t first, std::size_t count) {
    return std::string(reinterpret_cast<const char*>(values.data() + first),
                       count * sizeof(values[0]));
  };
  for (const char* axis : {"x", "y", "z"})
    text += "property " + std::visit(type_name, mesh.positions) + " " + axis + "\n";
  for (const Mesh::Attribute& attribute : mesh.attributes)
    text += "property " + std::visit(type_name, attribute.values) + " " + attribute.name + "\n";
  text += "element face " + std::to_string(mesh.face_count()) +
          "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    text += std::visit([&](const auto& xyz) { return bytes_from(xyz, 3 * i, 3); }, mesh.positions);
    for (const Mesh::Attribute& attribute : mesh.attributes) {
      text += std::visit([&](const auto& values) { return bytes_from(values, i, 1); },
                         attribute.values);
    }
  }
  for (std::size_t i = 0; i < mesh.face_count(); ++i)
    text += '\3' + bytes_from(mesh.faces, 3 * i, 3);
  return text;
}

}  // namespace winnow::test
