// What vertices carry besides their positions.
#pragma once

#include "base/number_type.hpp"
#include "base/vector.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace winnow {

// What the mean of several values is.
enum class AttributeKind {
  value,   // that of the numbers
  color,   // that of the light: a component as sRGB has it, whole numbers from 0 to the type's
           // highest
  normal,  // that of the vectors, as long as 1: nx, ny and nz, all three
  light,   // that of the numbers, which are of light already, from 0 to the type's highest; a color
           // elsewhere
  label    // there is none: the heaviest value counts, of equally heavy ones the smallest
};

// One number a vertex, as the input has it and the output gets it.
struct Attribute {
  std::string name;
  NumberType type = NumberType::float32;
  AttributeKind kind = AttributeKind::value;
  // What a colour's component has where all of it is there. 0: what the type has, see
  // full_component().
  double full = 0;
  std::optional<double> no_data{};  // a number that says that there is none

  [[nodiscard]] bool lacks(double stored) const {
    if (!no_data) return false;
    return stored == *no_data || (type == NumberType::float32 && stored == nearest_float(*no_data));
  }
};

// Bounds what a cell's sums take; enough for normals, colours, texture and a few measurements.
inline constexpr std::size_t most_attributes = 16;

// Those of an input, and the largest size of a number of each in it.
struct CarriedAttributes {
  std::vector<Attribute> attributes;
  std::vector<double> largest;

  [[nodiscard]] bool empty() const { return attributes.empty(); }
  // Of the means of one vertex.
  [[nodiscard]] std::size_t bytes() const { return attributes.size() * sizeof(double); }
};

std::vector<NumberType> types_of(std::span<const Attribute> attributes);

// The parts of a normal along the axes.
inline constexpr std::array<std::string_view, 3> normal_names{"nx", "ny", "nz"};

// Whether it has the name of a normal's part, of whatever kind it is.
inline bool names_normal(const Attribute& attribute) {
  return std::find(normal_names.begin(), normal_names.end(), attribute.name) != normal_names.end();
}
// The axis of one that does.
inline std::size_t axis_of_normal(const Attribute& attribute) {
  return static_cast<std::size_t>(attribute.name[1] - 'x');
}

inline bool carries_normals(std::span<const Attribute> attributes) {
  return std::any_of(attributes.begin(), attributes.end(),
                     [](const Attribute& a) { return a.kind == AttributeKind::normal; });
}

// The number that stands for all of a colour's component, or of its alpha.
double full_component(NumberType type);
double full_component(const Attribute& attribute);

// By the names that programs give them (red, diffuse_red or r, ...) which component a number is: 0
// red, 1 green, 2 blue, 3 alpha.
std::optional<std::size_t> component_named(std::string_view name);
// Whether numbers of this type can be one.
inline bool may_be_component(NumberType type) {
  return !is_integer(type) || type == NumberType::uint8 || type == NumberType::uint16;
}

// Whether it is a component of one, in whatever form.
inline bool is_color(const Attribute& attribute) {
  return attribute.kind == AttributeKind::color || attribute.kind == AttributeKind::light;
}

// From the number in a file to that whose means are taken, and from there to what is written, still
// to be rounded: of light, too, that is a colour as sRGB has it.
double mean_of_stored(const Attribute& attribute, double stored);
double stored_of_mean(const Attribute& attribute, double mean);

// "red (uchar)"
std::string described(const Attribute& attribute);

}  // namespace winnow
