// The attributes of a tile's vertices while its edges are collapsed. What is collapsed never
// depends on them.
#pragma once

#include "base/attribute.hpp"
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
  // `values`: one of each attribute of each vertex. `attributes` live as long as this.
  CarriedValues(std::span<const Attribute> attributes, std::vector<Point> positions,
                std::vector<double> values)
      : attributes_(attributes), position_(std::move(positions)), value_(std::move(values)) {}

  static constexpr std::uint64_t memory(std::uint64_t vertices, std::size_t attributes) {
    return attributes == 0 ? 0 : vertices * (sizeof(Point) + attributes * sizeof(double));
  }

  // To be told of every collapse. The vertex that is kept gets what is interpolated along the edge,
  // between its middle and the place nearest to where the vertex goes; of labels the nearer one. An
  // end without data does not count.
  void collapsed(const Collapse& edge);

  [[nodiscard]] std::span<const double> of(VertexNumber v) const {
    return std::span(value_).subspan(v * attributes_.size(), attributes_.size());
  }

 private:
  std::span<const Attribute> attributes_;
  std::vector<Point> position_;
  std::vector<double> value_;
};

}  // namespace winnow
