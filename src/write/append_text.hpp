// Numbers and words as text.
#pragma once

#include "write/mesh_encoder.hpp"

#include <array>
#include <charconv>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace winnow {

inline void append_text(std::vector<std::byte>& out, std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  out.insert(out.end(), bytes.begin(), bytes.end());
}

// The shortest text that is read back as the same number.
template <typename Number>
void append_number(std::vector<std::byte>& out, Number value) {
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  append_text(out, {text.data(), end});
}

// Three numbers with blanks between them.
template <typename Number>
void append_triple(std::vector<std::byte>& out, const std::array<Number, 3>& values) {
  append_number(out, values[0]);
  append_text(out, " ");
  append_number(out, values[1]);
  append_text(out, " ");
  append_number(out, values[2]);
}

// A position as a shape says: in the digits of a double, or in the fewer of a float.
inline void append_position(std::vector<std::byte>& out, const std::array<double, 3>& position,
                            bool as_double) {
  if (as_double) return append_triple(out, position);
  append_triple(out, std::array{static_cast<float>(position[0]), static_cast<float>(position[1]),
                                static_cast<float>(position[2])});
}

// A number as it is in a binary file of that type.
void append_rounded(std::vector<std::byte>& out, double value, NumberType type);

// As a float with a point or an exponent, so that it is never taken for a whole number.
void append_real(std::vector<std::byte>& out, double value);

// What lines of vertices of PLY and OFF begin with.
inline void append_geometry(std::vector<std::byte>& out, const MeshShape& shape,
                            const MeshVertex& vertex) {
  append_position(out, vertex.position, shape.double_positions);
  if (!shape.normals) return;
  append_text(out, " ");
  append_triple(out, vertex.normal);
}

// The lines of faces that they have in common.
inline void append_lines(std::vector<std::byte>& out, std::span<const MeshFace> faces) {
  for (const MeshFace& face : faces) {
    append_text(out, "3 ");
    append_triple(out, face.vertex);
    append_text(out, "\n");
  }
}

}  // namespace winnow
