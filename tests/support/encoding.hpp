// Meshes for encoders, and what an encoder makes of one.
#pragma once

#include "support/random.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "write/mesh_encoder.hpp"

#include <string>
#include <vector>

namespace winnow::test {

struct EncodedExample {
  MeshShape shape;
  std::vector<MeshVertex> vertices;
  std::vector<MeshFace> faces;
};

// Positions in a cube of this size around `middle`, of the type that they are going to be written
// in.
inline EncodedExample example_mesh(Random& random, std::size_t vertices, std::size_t faces,
                                   bool normals, bool doubles, const Point& middle = {},
                                   double half = 100) {
  EncodedExample out;
  out.shape = {vertices, faces, normals, doubles, "made for a test"};
  out.vertices.resize(vertices);
  for (MeshVertex& vertex : out.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = middle[axis] + random.real(-half, half);
      vertex.position[axis] = doubles ? x : static_cast<double>(static_cast<float>(x));
    }
    for (float& x : vertex.normal) x = static_cast<float>(random.real(-1, 1));
    out.shape.box.add(vertex.position);
  }
  out.faces.resize(faces);
  for (MeshFace& face : out.faces) {
    for (std::uint64_t& index : face.vertex) index = random.below(vertices);
  }
  return out;
}

// In parts of any size: the same calls give the same bytes.
inline std::string encoded(const MeshEncoder& encoder, const EncodedExample& mesh, Random& random) {
  std::vector<std::byte> bytes;
  std::size_t at = 0;
  for (const std::size_t part : random.parts(mesh.vertices.size(), 100)) {
    encoder.vertices(mesh.shape, at, std::span(mesh.vertices).subspan(at, part), bytes);
    at += part;
  }
  at = 0;
  for (const std::size_t part : random.parts(mesh.faces.size(), 100)) {
    std::vector<winnow::Corners> corners;
    const auto faces = std::span(mesh.faces).subspan(at, part);
    for (const MeshFace& face : faces) {
      corners.push_back({mesh.vertices[face.vertex[0]].position,
                         mesh.vertices[face.vertex[1]].position,
                         mesh.vertices[face.vertex[2]].position});
    }
    encoder.faces(mesh.shape, at, faces, corners, bytes);
    at += part;
  }
  return encoder.header(mesh.shape) + text_of(bytes) + encoder.footer(mesh.shape);
}

}  // namespace winnow::test
