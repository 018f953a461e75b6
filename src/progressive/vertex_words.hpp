// Vertices as words of which near ones are near numbers, and back: to the bit, or on a lattice.
#pragma once

#include "base/attribute.hpp"
#include "base/box.hpp"
#include "progressive/split.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

// How a coordinate is stored.
struct PositionForm {
  bool doubles = false;  // two words, else one; what comes out has that type
  unsigned bits = 0;     // of a lattice over the box, whose numbers are one word; 0: none
  Point origin{};        // of the lattice
  double step = 0;

  static PositionForm exact(bool doubles) { return {doubles, 0, {}, 0}; }
  static PositionForm lattice(bool doubles, unsigned bits, const Box& box);

  [[nodiscard]] std::size_t words() const { return bits == 0 && doubles ? 6 : 3; }
  bool operator==(const PositionForm&) const = default;
};

class VertexWords {
 public:
  VertexWords(const PositionForm& form, std::vector<Attribute> attributes);

  // Words a vertex.
  [[nodiscard]] std::size_t width() const { return width_; }

  // Appends the words of a vertex. `means`: what it carries, as refinement has it.
  void put(const Point& position, std::span<const double> means, Words& out) const;
  [[nodiscard]] Point position(std::span<const std::uint32_t> words) const;
  void means(std::span<const std::uint32_t> words, std::span<double> out) const;

 private:
  PositionForm form_;
  std::vector<Attribute> attributes_;
  std::size_t width_;
};

}  // namespace winnow
