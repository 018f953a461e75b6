#include "read/ply/vertices.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/ply/scalar.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace winnow {

bool PlyVertices::carries(std::size_t scalar) const {
  return std::binary_search(facts_.choice.scalar.begin(), facts_.choice.scalar.end(), scalar);
}

VertexLayout PlyVertices::layout_of(const PlyElement& element) const {
  VertexLayout layout;
  layout.swapped = form_ == PlyForm::big_endian;
  std::array<bool, 3> found{};
  std::size_t scalar = 0;
  for (const PlyProperty& property : element.properties) {
    if (!property.list && !is_coordinate(property) && carries(scalar++))
      layout.attributes.push_back({layout.stride, property.type});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (property.list || property.name != std::string(1, static_cast<char>('x' + axis))) continue;
      layout.offset[axis] = layout.stride;
      layout.type[axis] = property.type;
      found[axis] = true;
    }
    layout.stride += size_of(property.type);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (found[axis]) continue;
    throw Error(ErrorKind::bad_input, "'" + source_.name() +
                                          "': the PLY element 'vertex' has no property '" +
                                          std::string(1, static_cast<char>('x' + axis)) + "'");
  }
  return layout;
}

void PlyVertices::read(const PlyElement& element, VertexStore& vertices) {
  if (element.count > UINT32_MAX) {
    throw Error(ErrorKind::bad_input, "'" + source_.name() + "' says it has " +
                                          grouped(element.count) +
                                          " vertices; indices of PLY count to 4,294,967,295");
  }
  if (element.count == 0) {
    vertices.begin_keeping(false);
    return vertices.finish_keeping();
  }
  const VertexLayout layout = layout_of(element);
  const bool fixed = form_ != PlyForm::ascii && element.fixed_size();
  if (fixed && !source_.map_name().empty()) {
    const std::uint64_t bytes = element.count * layout.stride;
    vertices.map(source_.map_name(), source_.position(), element.count, layout, source_.scratch());
    source_.seek(source_.position() + bytes);
    return;
  }
  job_.progress.begin("read vertices", element.count, "vertices");
  vertices.begin_keeping(facts_.double_positions, types_of(facts_.choice.carried));
  if (fixed) {
    keep_fixed(element, layout, vertices);
  } else {
    keep_values(element, vertices);
  }
  vertices.finish_keeping();
}

void PlyVertices::keep_fixed(const PlyElement& element, const VertexLayout& layout,
                             VertexStore& vertices) {
  std::vector<double> xyz;
  std::vector<double> attributes;
  for (std::uint64_t done = 0; done < element.count;) {
    const std::size_t at_once =
        std::clamp<std::size_t>((std::size_t{1} << 18) / layout.stride, 1, 8192);
    const std::size_t count = std::min<std::uint64_t>(at_once, element.count - done);
    const Block block = source_.take(count * layout.stride);
    if (block.bytes.size() < count * layout.stride) {
      throw Error(ErrorKind::bad_input, "'" + source_.name() + "' ends at byte " +
                                            grouped(source_.position()) + ", inside vertex " +
                                            grouped(done + block.bytes.size() / layout.stride) +
                                            " of " + grouped(element.count) + ": it was cut short");
    }
    xyz.resize(3 * count);
    attributes.clear();
    const std::byte* record = block.bytes.data();
    const bool floats =
        !layout.swapped &&
        layout.type == std::array{PlyType::float32, PlyType::float32, PlyType::float32};
    for (std::size_t i = 0; i < count; ++i, record += layout.stride) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        xyz[3 * i + axis] =
            floats ? load<float>(record + layout.offset[axis], false)
                   : load_real(record + layout.offset[axis], layout.type[axis], layout.swapped);
      }
      for (const auto& [offset, type] : layout.attributes)
        attributes.push_back(load_real(record + offset, type, layout.swapped));
    }
    vertices.keep(xyz, attributes);
    done += count;
    job_.progress.advance(count);
  }
}

void PlyVertices::keep_values(const PlyElement& element, VertexStore& vertices) {
  std::vector<double> xyz;
  std::vector<double> attributes;
  constexpr int skipped = -1;
  constexpr int carried = 3;
  std::vector<int> use;  // of each property: an axis, or ...
  std::size_t scalar = 0;
  for (const PlyProperty& property : element.properties) {
    if (is_coordinate(property)) {
      use.push_back(property.name[0] - 'x');
    } else {
      use.push_back(!property.list && carries(scalar++) ? carried : skipped);
    }
  }
  for (std::uint64_t done = 0; done < element.count; ++done) {
    values_.now_reading("vertex", done);
    xyz.resize(xyz.size() + 3);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (use[i] == skipped) {
        skip_property(values_, property);
      } else if (use[i] == carried) {
        attributes.push_back(values_.real(property.type));
      } else {
        xyz[xyz.size() - 3 + static_cast<std::size_t>(use[i])] = values_.real(property.type);
      }
    }
    if (xyz.size() < 3 * 4096 && done + 1 < element.count) continue;
    vertices.keep(xyz, attributes);
    job_.progress.advance(xyz.size() / 3);
    xyz.clear();
    attributes.clear();
  }
}

}  // namespace winnow
