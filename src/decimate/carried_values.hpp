// The attributes of a tile's vertices while its edges are collapsed. What is collapsed never depends on them.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

class CarriedValues {
 public:
  // Of no vertices: nothing is carried.
  CarriedValues() = default;
  // `values`: so many of each vertex.
  CarriedValues(std::size_t attributes, std::vector<Point> positions, std::vector<double> values)
      : attributes_(attributes), position_(std::move(positions)), value_(std::move(values)) {}

  static constexpr std::uint64_t memory(std::uint64_t vertices, std::size_t attributes) {
    return attributes == 0 ? 0 : vertices * (sizeof(Point) + attributes * sizeof(double));
  }

  // To be told of every collapse. The vertex that is kept gets what is interpolated along the edge, between
  // its middle and the place nearest to where the vertex goes.
  void collapsed(const Collapse& edge);

  [[nodiscard]] std::span<const double> of(VertexNumber v) const {
    return std::span(value_).subspan(v * attributes_, attributes_);
  }

 private:
  std::size_t attributes_ = 0;
  std::vector<Point> position_;
  std::vector<double> value_;
};

}  // namespace winnow
