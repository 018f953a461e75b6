// From numbers in a file to whole numbers that can be added up in any order, and back.
#pragma once

#include "base/attribute.hpp"
#include "base/wide.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// Of one attribute: what its means are taken of (of labels the values themselves), times a power of
// two at which the largest number of the input takes 62 bits. So floats of 2^-38 of the largest are
// still exact, and what is lost of any number is below 2^-61 of the largest.
class AttributeScale {
 public:
  // `largest`: the largest size of a number in the input; larger ones are none.
  AttributeScale(const Attribute& attribute, double largest);

  static constexpr std::int64_t none = INT64_MIN;

  [[nodiscard]] std::int64_t fixed(double stored) const {
    if (!table_.empty()) {
      const bool there = stored >= 0 && stored < static_cast<double>(table_.size());
      return there ? table_[static_cast<std::size_t>(stored)] : none;
    }
    if (attribute_.lacks(stored)) return none;
    return scaled(is_color(attribute_) ? mean_of_stored(attribute_, stored) : stored);
  }

  [[nodiscard]] bool is_label() const { return attribute_.kind == AttributeKind::label; }
  // Where nothing was added.
  [[nodiscard]] double nothing() const { return attribute_.no_data.value_or(0); }

  // The mean of fixed numbers whose weighted sum this is; `weight` is not 0.
  [[nodiscard]] double mean(Int128 sum, std::uint64_t weight) const;

 private:
  [[nodiscard]] std::int64_t scaled(double mean) const {
    const double number = mean * up_[0] * up_[1];
    return std::abs(number) <= 0x1p62 ? static_cast<std::int64_t>(number) : none;
  }

  Attribute attribute_;
  // The power of two, and one by it, as products of two: of tiny numbers it is more than a double
  // holds.
  std::array<double, 2> up_{}, down_{};
  std::vector<std::int64_t> table_;  // of all numbers there are, where colours are whole
};

std::vector<AttributeScale> scales_of(const CarriedAttributes& carried);

}  // namespace winnow
