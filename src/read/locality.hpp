// Whether faces name vertices near each other, or jump.
#pragma once

#include "read/vertex_store.hpp"

#include <cstdint>
#include <span>

namespace winnow {

// From stretches of faces, an estimate of what looking up their vertices would have to read of the mapped
// vertices: a simulation of what VertexStore::gather() does.
class Locality {
 public:
  explicit Locality(const VertexStore& vertices) : vertices_(vertices) {}

  // Faces that follow each other: three vertex numbers each, which need not be of any.
  void add_stretch(std::span<const std::uint32_t> numbers);

  // Bytes that lookups of so many faces read, in pages.
  [[nodiscard]] double lookup_bytes(std::uint64_t faces) const;

 private:
  const VertexStore& vertices_;
  std::uint64_t faces_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace winnow
