#include "support/shape_files.hpp"

#include <cstdint>

namespace winnow::test {

namespace {

template <typename T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

Shape as_stored(Shape shape, Numbers numbers) {
  if (numbers == Numbers::doubles) return shape;
  for (Point& p : shape.vertices) {
    for (double& x : p) x = nearest_float(x);
  }
  return shape;
}

std::string ply_of(const Shape& shape, Numbers numbers) {
  const bool doubles = numbers == Numbers::doubles;
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  bytes += std::to_string(shape.vertices.size()) + "\n";
  for (const char* axis : {"x", "y", "z"})
    bytes += std::string("property ") + (doubles ? "double " : "float ") + axis + "\n";
  bytes += "element face " + std::to_string(shape.faces.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point& p : shape.vertices) {
    for (const double x : p) {
      if (doubles)
        put(bytes, x);
      else
        put(bytes, static_cast<float>(x));
    }
  }
  for (const auto& face : shape.faces) {
    put(bytes, std::uint8_t{3});
    for (const std::uint32_t v : face) put(bytes, v);
  }
  return bytes;
}

}  // namespace winnow::test
