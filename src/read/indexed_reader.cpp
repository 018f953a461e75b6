#include "read/indexed_reader.hpp"

#include "read/ply_scalar.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

void IndexedReader::begin_positions(PassCorners /*corners*/) {
  vertices_.wake();
  next_position_ = 0;
}

bool IndexedReader::next_positions(RawBatch& batch) {
  batch = {};
  batch.first = next_position_;
  batch.count = std::min<std::uint64_t>(memory_.batch_faces, vertices_.size() - next_position_);
  next_position_ += batch.count;
  return batch.count > 0;
}

void IndexedReader::decode_positions(const RawBatch& batch, FaceBatch& slice,
                                     const PositionSink& sink) const {
  const std::array<double*, 3> out{slice.position[0][0].data(), slice.position[0][1].data(),
                                   slice.position[0][2].data()};
  for (std::uint64_t from = 0; from < batch.count; from += FaceBatch::capacity) {
    const std::size_t count = std::min<std::uint64_t>(FaceBatch::capacity, batch.count - from);
    vertices_.read(batch.first + from, count, out);
    sink({{out[0], out[1], out[2]}, count, batch.first + from, 0});
  }
  vertices_.check_intact(source_->name());
}

std::optional<std::array<double, 3>> IndexedReader::first_finite_position() {
  std::array<double, 3> xyz{};
  for (std::uint64_t i = 0; i < vertices_.size(); ++i) {
    vertices_.read(i, 1, {&xyz[0], &xyz[1], &xyz[2]});
    if (std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2])) return xyz;
  }
  return {};
}

std::vector<MeshReader::AttributeRange> IndexedReader::attribute_ranges() {
  const auto& attributes = facts_.choice.carried;
  std::vector<AttributeRange> ranges(attributes.size());
  std::vector<std::size_t> real;
  for (std::size_t k = 0; k < attributes.size(); ++k) {
    const auto bits = static_cast<int>(8 * size_of(attributes[k].type));
    if (is_integer(attributes[k].type)) {
      ranges[k].largest = std::ldexp(1, bits) - 1;
    } else {
      real.push_back(k);
    }
  }
  if (real.empty()) return ranges;
  job_.progress.begin("measure attributes", vertices_.size(), "vertices");
  vertices_.wake();
  const VertexLayout& layout = vertices_.layout();
  vertices_.for_each_stretch([&](const std::byte* record, std::size_t count) {
    job_.progress.advance(count);
    for (std::size_t i = 0; i < count; ++i, record += layout.stride) {
      for (const std::size_t k : real) {
        const auto [offset, type] = layout.attributes[k];
        const double size = std::abs(load_real(record + offset, type, layout.swapped));
        if (std::isfinite(size)) {
          ranges[k].largest = std::max(ranges[k].largest, size);
        } else {
          ++ranges[k].not_finite;
        }
      }
    }
  });
  vertices_.check_intact(source_->name());
  return ranges;
}

std::vector<ScalarType> IndexedReader::carried_types() const {
  std::vector<ScalarType> types;
  for (const Attribute& attribute : facts_.choice.carried) types.push_back(attribute.type);
  return types;
}

}  // namespace winnow
