// The header of a PLY file.
#pragma once

#include "base/number_type.hpp"
#include "io/byte_source.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace winnow {

using PlyType = NumberType;

struct PlyProperty {
  std::string name;
  PlyType type{};
  bool list = false;
  PlyType count_type{};  // of a list
};

// x, y or z.
inline bool is_coordinate(const PlyProperty& property) {
  return !property.list && property.name.size() == 1 && property.name[0] >= 'x' &&
         property.name[0] <= 'z';
}

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  [[nodiscard]] const PlyProperty* find(const std::string& property) const;
  [[nodiscard]] bool fixed_size() const;            // no lists
  [[nodiscard]] std::size_t smallest_size() const;  // of one record in a binary file, lists empty
};

enum class PlyForm : std::uint8_t { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyForm form{};
  std::vector<PlyElement> elements;
  std::uint64_t bytes = 0;  // of the header itself

  [[nodiscard]] const PlyElement* find(const std::string& element) const;
};

// Whether the first line is that of one.
bool begins_like_ply(std::string_view head);

// Reads the header and leaves `source` right behind it. Throws Error(bad_input), naming the line.
PlyHeader read_ply_header(ByteSource& source);

}  // namespace winnow
