// Progressive files of meshes, and what is in them.
#pragma once

#include <winnow/mesh.hpp>
#include <winnow/progressive.hpp>

#include "base/number_type.hpp"
#include "support/files.hpp"
#include "support/refining.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

// A context that scratches in a directory of its own.
struct ProgressivePlace {
  ProgressivePlace() {
    context.scratch = directory.path();
    context.threads = 2;
  }

  // A file of this mesh; `name` stands for it.
  std::string made(const std::string& mesh, const ProgressiveOptions& options = {},
                   const std::string& name = "mesh.wpm") {
    ProgressiveOptions forced = options;
    forced.force = true;
    report = progressive(context, {mesh}, directory.file(name), forced);
    return directory.file(name);
  }
  // So many faces of it, as a file.
  std::string extracted(const std::string& file, const Target& target,
                        const std::string& name = "level.ply") {
    ExtractOptions options;
    options.target = target;
    options.raw = raw;
    options.force = true;
    extract_report = extract(context, file, directory.file(name), options);
    return directory.file(name);
  }

  Directory directory;
  Context context;
  bool raw = false;
  ProgressiveReport report;
  ExtractReport extract_report;
};

// The faces of a mesh by what is at their corners, to the bit, whatever the order of vertices, of
// faces, and of the corners in a face.
inline std::vector<std::string> faces_by_content(const Mesh& mesh) {
  std::vector<std::string> vertices(mesh.vertex_count());
  const auto append = [&](const auto& numbers, std::size_t each) {
    using Number = typename std::decay_t<decltype(numbers)>::value_type;
    for (std::size_t v = 0; v < vertices.size(); ++v)
      vertices[v].append(reinterpret_cast<const char*>(&numbers[each * v]), each * sizeof(Number));
  };
  std::visit([&](const auto& positions) { append(positions, 3); }, mesh.positions);
  for (const Mesh::Attribute& attribute : mesh.attributes)
    std::visit([&](const auto& values) { append(values, 1); }, attribute.values);
  std::vector<std::string> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); f += 3) {
    std::array<std::string, 3> corners{vertices[mesh.faces[f]], vertices[mesh.faces[f + 1]],
                                       vertices[mesh.faces[f + 2]]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    faces.push_back(corners[0] + corners[1] + corners[2]);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

// All faces of a file after welding, and nothing else done to them.
inline Mesh welded_input(Context& context, const std::string& mesh) {
  SimplifyOptions all;
  all.target = Target::ratio(1);
  all.detail = std::numeric_limits<double>::infinity();
  return simplify(context, mesh, all);
}

}  // namespace winnow::test
