// Whether faces name vertices near each other, or jump.
#pragma once

#include "read/indexed/vertex_store.hpp"

#include <cstdint>
#include <span>

namespace winnow {

// From stretches of faces, an estimate of what looking up their vertices would have to read of the
// mapped vertices: a simulation of what VertexStore::gather() does.
class Locality {
 public:
  // `near`: by how much the numbers of the vertices of one face may be apart.
  Locality(const VertexStore& vertices, std::uint64_t near) : vertices_(vertices), near_(near) {}

  // Faces that follow each other: three vertex numbers each, which need not be of any.
  void add_stretch(std::span<const std::uint32_t> numbers);

  // Bytes that lookups of so many faces read, in pages.
  [[nodiscard]] double lookup_bytes(std::uint64_t faces) const;

  // The part of the faces whose vertices are not near each other.
  [[nodiscard]] double far_part() const {
    return seen_ == 0 ? 0 : static_cast<double>(far_) / static_cast<double>(seen_);
  }

 private:
  const VertexStore& vertices_;
  std::uint64_t near_;
  std::uint64_t seen_ = 0, far_ = 0;
  std::uint64_t faces_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace winnow
