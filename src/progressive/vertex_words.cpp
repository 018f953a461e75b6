#include "progressive/vertex_words.hpp"

#include "base/number_type.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace winnow {

namespace {

// The order of reals as that of whole numbers.
std::uint32_t ordinal_of(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return bits >> 31 != 0 ? ~bits : bits | 0x80000000U;
}
float float_of(std::uint32_t ordinal) {
  return std::bit_cast<float>(ordinal >> 31 != 0 ? ordinal & 0x7FFFFFFFU : ~ordinal);
}

void put_double(double value, std::uint32_t*& at) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const std::uint64_t ordinal = bits >> 63 != 0 ? ~bits : bits | std::uint64_t{1} << 63;
  *at++ = static_cast<std::uint32_t>(ordinal >> 32);
  *at++ = static_cast<std::uint32_t>(ordinal);
}
double double_of(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t ordinal = std::uint64_t{high} << 32 | low;
  return std::bit_cast<double>(ordinal >> 63 != 0 ? ordinal & ~(std::uint64_t{1} << 63) : ~ordinal);
}

std::size_t words_of(NumberType type) {
  return type == NumberType::float64 ? 2 : 1;
}

// As the input stores it: of light a part of the type's highest.
double stored_number(const Attribute& attribute, double mean) {
  return attribute.kind == AttributeKind::light ? mean * full_component(attribute)
                                                : stored_of_mean(attribute, mean);
}

void put_word(std::uint32_t word, std::uint32_t*& at) {
  *at++ = word;
}

void put_number(const Attribute& attribute, double stored, std::uint32_t*& at) {
  with_type(attribute.type, [&]<typename Number>(Number) {
    std::array<std::byte, sizeof(Number)> bytes{};
    store_rounded(stored, attribute.type, bytes.data());
    Number number{};
    std::memcpy(&number, bytes.data(), sizeof number);
    if constexpr (std::is_same_v<Number, double>) {
      put_double(number, at);
    } else if constexpr (std::is_same_v<Number, float>) {
      put_word(ordinal_of(number), at);
    } else {
      put_word(static_cast<std::uint32_t>(number), at);
    }
  });
}

double number_of(const Attribute& attribute, const std::uint32_t* words) {
  return with_type(attribute.type, [&]<typename Number>(Number) -> double {
    if constexpr (std::is_same_v<Number, double>) {
      return double_of(words[0], words[1]);
    } else if constexpr (std::is_same_v<Number, float>) {
      return float_of(words[0]);
    } else {
      return static_cast<Number>(words[0]);
    }
  });
}

// Vectors nearer to this length are left as they are, so that normals of the input stay what they
// were.
constexpr double unit_tolerance = 1e-6;
// Steps of a lattice.
constexpr double far_beside = 1 << 30;

}  // namespace

PositionForm PositionForm::lattice(bool doubles, unsigned bits, const Box& box) {
  const double side = box.longest_side();
  const double steps = std::ldexp(1.0, static_cast<int>(bits)) - 1;
  return {doubles, bits, box.low, side > 0 ? side / steps : 1};
}

VertexWords::VertexWords(const PositionForm& form, std::vector<Attribute> attributes)
    : form_(form), attributes_(std::move(attributes)), width_(form.words()) {
  for (const Attribute& attribute : attributes_) width_ += words_of(attribute.type);
}

void VertexWords::put(const Point& position, std::span<const double> means, Words& out) const {
  out.resize(out.size() + width_);
  std::uint32_t* at = out.data() + out.size() - width_;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (form_.bits > 0) {
      // What was collapsed may lie beside the box.
      const double step = std::nearbyint((position[axis] - form_.origin[axis]) / form_.step);
      *at++ = static_cast<std::uint32_t>(
          static_cast<std::int32_t>(std::clamp(step, -far_beside, far_beside)));
    } else if (form_.doubles) {
      put_double(position[axis], at);
    } else {
      *at++ = ordinal_of(static_cast<float>(position[axis]));
    }
  }
  if (attributes_.empty()) return;
  double square = 0;
  for (std::size_t i = 0; i < attributes_.size(); ++i) {
    if (attributes_[i].kind == AttributeKind::normal) square += means[i] * means[i];
  }
  const double length = std::sqrt(square);
  const bool scaled = length > 0 && std::abs(length - 1) > unit_tolerance;
  for (std::size_t i = 0; i < attributes_.size(); ++i) {
    const bool normal = attributes_[i].kind == AttributeKind::normal;
    const double stored = stored_number(attributes_[i], means[i]);
    put_number(attributes_[i], normal && scaled ? stored / length : stored, at);
  }
}

Point VertexWords::position(std::span<const std::uint32_t> words) const {
  Point position{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (form_.bits > 0) {
      const double at = form_.origin[axis] + form_.step * static_cast<std::int32_t>(words[axis]);
      position[axis] = form_.doubles ? at : static_cast<float>(at);
    } else if (form_.doubles) {
      position[axis] = double_of(words[2 * axis], words[2 * axis + 1]);
    } else {
      position[axis] = float_of(words[axis]);
    }
  }
  return position;
}

void VertexWords::means(std::span<const std::uint32_t> words, std::span<double> out) const {
  std::size_t at = form_.words();
  for (std::size_t i = 0; i < attributes_.size(); ++i) {
    out[i] = mean_of_stored(attributes_[i], number_of(attributes_[i], words.data() + at));
    at += words_of(attributes_[i].type);
  }
}

}  // namespace winnow
