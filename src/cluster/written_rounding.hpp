// How exactly positions were written, whatever type holds them now.
#pragma once

#include "base/rounding.hpp"

#include <array>
#include <cstdint>

namespace winnow {

// Doubles are often read from text of six or nine digits, or were floats before. Faces thinner than
// that rounding have no normal, too. A part of the values, chosen by a hash, is looked at, so order
// and threads do not matter; objects for several threads are added up.
class WrittenRounding {
 public:
  void add(double coordinate);
  void add(const WrittenRounding& other);

  // By how much coordinates may be off. That of doubles where they use all their digits, and where
  // the rounding would not be small beside `side`, the box's longest side: then numbers such as
  // whole metres are meant as they are. `largest`: magnitude of a coordinate.
  [[nodiscard]] CoordinateRounding rounding(double side, double largest) const;

 private:
  static constexpr int decades = 700;

  void look(double coordinate);

  bool all_digits_ = false;    // of some
  bool floats_ = true;         // as far as digits tell, all were floats once
  int digits_ = 0;             // most that any has
  int last_ = decades;         // decade of the lowest digit of any
  int top_ = -decades;         // highest decade of any with a fraction that no float has ...
  int last_of_top_ = decades;  // ... and of the lowest digit of these
};

}  // namespace winnow
