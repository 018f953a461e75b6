// The faces of a batch that are faces, and what is wrong with the others.
#pragma once

#include <winnow/simplify.hpp>

#include "base/vector.hpp"
#include "read/face_batch.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace winnow {

struct NumberedFace {
  Triangle corner;
  std::uint64_t number;
};

// The first face that cannot take part, for messages.
struct FirstBad {
  std::uint64_t face = UINT64_MAX;
  const char* what = "";

  void add(const FirstBad& other) {
    if (other.face < face) *this = other;
  }
};

// What --strict makes of it: throws Error(bad_input).
[[noreturn]] void refuse_bad_face(const std::string& name, const FirstBad& bad);

// Those whose corners exist, are finite and stand in three places; the others are counted by kind.
class GoodFaces {
 public:
  explicit GoodFaces(const FaceBatch& faces);

  [[nodiscard]] std::span<const NumberedFace> faces() const { return {good_.data(), count_}; }
  [[nodiscard]] const BadFaces& bad() const { return bad_; }
  [[nodiscard]] const FirstBad& first_bad() const { return first_bad_; }
  [[nodiscard]] std::uint64_t cropped() const { return cropped_; }  // not bad, but not asked for

 private:
  std::array<NumberedFace, FaceBatch::capacity> good_;
  std::size_t count_ = 0;
  BadFaces bad_;
  std::uint64_t cropped_ = 0;
  FirstBad first_bad_;
};

}  // namespace winnow
