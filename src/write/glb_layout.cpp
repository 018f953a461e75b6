// Binary glTF 2.0 (Khronos Group; ISO/IEC 12113): a header, a chunk of JSON, a chunk of vertices and indices.
#include "write/glb_layout.hpp"

#include <winnow/error.hpp>

#include "base/srgb.hpp"
#include "base/text.hpp"
#include "base/vector.hpp"
#include "write/append.hpp"
#include "write/vertex_colors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace winnow {

namespace {

constexpr std::uint64_t index_bytes = sizeof(std::uint32_t);
const std::string extension = "EXT_meshopt_compression";

std::string number(std::uint64_t value) {
  return std::to_string(value);
}

std::string list(const Point& values) {
  return "[" + shortest(values[0]) + "," + shortest(values[1]) + "," + shortest(values[2]) + "]";
}

// One after the other, with commas between.
template <typename Text>
void emit_list(std::size_t count, const Emit& emit, const Text& text) {
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) emit(",");
    emit(text(i));
  }
}

// Components of colours, if the shape has any.
std::uint64_t color_components(const MeshShape& shape) {
  const VertexColors colors(shape.attributes);
  return colors.any() ? (colors.alpha() ? 4 : 3) : 0;
}

// Of each block: positions, indices and, if it has them, normals and colours.
struct Numbers {
  explicit Numbers(const MeshShape& shape)
      : normals(shape.normals ? 1 : 0), colors(color_components(shape) > 0 ? 1 : 0) {}

  std::size_t normals, colors;
  [[nodiscard]] std::size_t first(std::size_t block) const { return (2 + normals + colors) * block; }
  [[nodiscard]] std::string position(std::size_t block) const { return number(first(block)); }
  [[nodiscard]] std::string indices(std::size_t block) const { return number(first(block) + 1); }
  [[nodiscard]] std::string normal(std::size_t block) const { return number(first(block) + 2); }
  [[nodiscard]] std::string color(std::size_t block) const { return number(first(block) + 2 + normals); }
};

std::string vertex_accessor(std::size_t block, std::uint64_t offset, const MeshBlock& of,
                            std::uint64_t components = 3) {
  return R"({"bufferView":)" + number(2 * block) + R"(,"byteOffset":)" + number(offset) +
         R"(,"componentType":5126,"count":)" + number(of.vertices) + R"(,"type":"VEC)" + number(components) +
         "\"";
}

std::string accessors_of(const MeshShape& shape, std::size_t block, const MeshBlock& of) {
  std::string text = vertex_accessor(block, 0, of) + R"(,"min":)" + list(of.box.low) + R"(,"max":)" +
                     list(of.box.high) + R"(},{"bufferView":)" + number(2 * block + 1) +
                     R"(,"componentType":5125,"count":)" + number(3 * of.faces) + R"(,"type":"SCALAR"})";
  if (shape.normals) text += "," + vertex_accessor(block, 3 * sizeof(float), of) + "}";
  if (const std::uint64_t components = color_components(shape); components > 0) {
    const std::uint64_t offset = glb_stride(shape) - components * sizeof(float);
    text += "," + vertex_accessor(block, offset, of, components) + "}";
  }
  return text;
}

// A stretch of the mesh's bytes, and of what they are packed to.
struct View {
  std::uint64_t begin = 0, bytes = 0, packed_begin = 0, packed_bytes = 0;
  std::uint64_t stride = 0, count = 0;
  bool vertices = false;
};

std::string view_of(const View& view, bool packed) {
  std::string text = std::string(R"({"buffer":)") + (packed ? "1" : "0") + R"(,"byteOffset":)" +
                     number(view.begin) + R"(,"byteLength":)" + number(view.bytes);
  if (view.vertices) text += R"(,"byteStride":)" + number(view.stride);
  text += std::string(R"(,"target":)") + (view.vertices ? "34962" : "34963");
  if (packed) {
    text += R"(,"extensions":{")" + extension + R"(":{"buffer":0,"byteOffset":)" + number(view.packed_begin) +
            R"(,"byteLength":)" + number(view.packed_bytes) + R"(,"byteStride":)" + number(view.stride) +
            R"(,"count":)" + number(view.count) + R"(,"mode":")" +
            (view.vertices ? "ATTRIBUTES" : "TRIANGLES") + R"("}})";
  }
  return text + "}";
}

std::uint64_t whole_bytes(const MeshShape& shape, const MeshBlock& block) {
  return block.vertices * glb_stride(shape) + block.faces * 3 * index_bytes;
}

std::uint64_t packed_bytes(const MeshBlock& block) {
  return whole_words(block.vertex_bytes) + whole_words(block.index_bytes);
}

void emit_json(const MeshShape& shape, std::span<const MeshBlock> blocks, bool packed, const Emit& emit) {
  const Point offset = glb_offset(shape);
  const Numbers numbers(shape);
  emit(R"({"asset":{"version":"2.0","generator":"winnow"},)");
  if (packed)
    emit(R"("extensionsUsed":[")" + extension + R"("],"extensionsRequired":[")" + extension + R"("],)");
  emit(R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)");
  if (offset != Point{}) emit(R"(,"translation":)" + list(offset));
  emit(R"(}],"meshes":[{"primitives":[)");
  emit_list(blocks.size(), emit, [&](std::size_t i) {
    return R"({"attributes":{"POSITION":)" + numbers.position(i) +
           (numbers.normals > 0 ? R"(,"NORMAL":)" + numbers.normal(i) : "") +
           (numbers.colors > 0 ? R"(,"COLOR_0":)" + numbers.color(i) : "") + R"(},"indices":)" +
           numbers.indices(i) + "}";
  });
  emit(R"(]}],"accessors":[)");
  emit_list(blocks.size(), emit, [&](std::size_t i) { return accessors_of(shape, i, blocks[i]); });
  emit(R"(],"bufferViews":[)");
  View view;
  emit_list(blocks.size(), emit, [&](std::size_t i) {
    const MeshBlock& block = blocks[i];
    const auto next = [&](bool vertices, std::uint64_t count, std::uint64_t stride, std::uint64_t bytes) {
      view = {view.begin + view.bytes,
              count * stride,
              whole_words(view.packed_begin + view.packed_bytes),
              bytes,
              stride,
              count,
              vertices};
      return view_of(view, packed);
    };
    const std::string vertices = next(true, block.vertices, glb_stride(shape), block.vertex_bytes);
    return vertices + "," + next(false, 3 * block.faces, index_bytes, block.index_bytes);
  });
  const std::uint64_t whole = view.begin + view.bytes;
  emit(R"(],"buffers":[{"byteLength":)" +
       number(packed ? whole_words(view.packed_begin + view.packed_bytes) : whole) + "}");
  // Where the bytes would be, were they not packed: nowhere.
  if (packed)
    emit(R"(,{"byteLength":)" + number(whole) + R"(,"extensions":{")" + extension +
         R"(":{"fallback":true}}})");
  emit("]}");
}

}  // namespace

Point glb_offset(const MeshShape& shape) {
  Point offset{};
  const double side = shape.box.longest_side();
  if (!shape.double_positions || shape.box.empty || !(side > 0)) return offset;
  const double step = std::ldexp(1.0, std::ilogb(side));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = shape.box.low[axis];
    const double high = shape.box.high[axis];
    if (std::max(std::abs(low), std::abs(high)) > 2 * side) offset[axis] = std::floor(low / step) * step;
  }
  return offset;
}

namespace {

// No other length is allowed; for a vertex that has no normal one is as good as another.
std::array<float, 3> unit_normal(const std::array<float, 3>& normal) {
  const Point exact{normal[0], normal[1], normal[2]};
  const double square = dot(exact, exact);
  if (std::abs(square - 1) <= 1e-6) return normal;
  if (!(square > 0)) return {0, 0, 1};
  const Point of_one = unit(exact);
  return {static_cast<float>(of_one[0]), static_cast<float>(of_one[1]), static_cast<float>(of_one[2])};
}

}  // namespace

std::uint64_t glb_stride(const MeshShape& shape) {
  return ((shape.normals ? 6 : 3) + color_components(shape)) * sizeof(float);
}

void append_glb_vertices(const MeshShape& shape, const Point& offset, std::span<const MeshVertex> vertices,
                         std::vector<std::byte>& out) {
  const VertexColors colors(shape.attributes);
  const std::uint64_t components = color_components(shape);
  for (const MeshVertex& vertex : vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      append(out, static_cast<float>(vertex.position[axis] - offset[axis]));
    if (shape.normals) {
      append(out, unit_normal(vertex.normal));
    }
    for (std::size_t i = 0; i < components; ++i) {
      const double component = std::clamp(colors.component(vertex, i), 0.0, 1.0);
      append(out, static_cast<float>(i < 3 ? light_of_component(component) : component));
    }
  }
}

Box written_box(const Box& box, const Point& offset) {
  Box written = box;
  for (Point* corner : {&written.low, &written.high}) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      (*corner)[axis] = nearest_float((*corner)[axis] - offset[axis]);
  }
  return written;
}

void emit_glb_head(const MeshShape& shape, std::span<const MeshBlock> blocks, bool packed, const Emit& emit) {
  constexpr std::uint64_t header_bytes = 12;
  constexpr std::uint64_t chunk_header_bytes = 8;
  // Twice: its length stands before it.
  std::uint64_t json_bytes = 0;
  emit_json(shape, blocks, packed, [&](std::string_view text) { json_bytes += text.size(); });
  const std::uint64_t blanks = whole_words(json_bytes) - json_bytes;
  json_bytes += blanks;
  std::uint64_t binary_bytes = 0;
  for (const MeshBlock& block : blocks)
    binary_bytes += packed ? packed_bytes(block) : whole_bytes(shape, block);
  const std::uint64_t all = header_bytes + 2 * chunk_header_bytes + json_bytes + binary_bytes;
  if (all > UINT32_MAX) refuse_glb_size(shape.faces);

  const auto emit_bytes = [&](const std::vector<std::byte>& bytes) {
    emit({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  };
  std::vector<std::byte> head;
  append(head, std::array{'g', 'l', 'T', 'F'});
  append(head, std::uint32_t{2});
  append(head, static_cast<std::uint32_t>(all));
  append(head, static_cast<std::uint32_t>(json_bytes));
  append(head, std::array{'J', 'S', 'O', 'N'});
  emit_bytes(head);
  emit_json(shape, blocks, packed, emit);
  emit(std::string(blanks, ' '));
  head.clear();
  append(head, static_cast<std::uint32_t>(binary_bytes));
  append(head, std::array{'B', 'I', 'N', '\0'});
  emit_bytes(head);
}

void check_floats(const Box& box) {
  constexpr double most = std::numeric_limits<float>::max();
  for (const Point& corner : {box.low, box.high}) {
    for (const double value : corner) {
      if (std::abs(value) <= most) continue;
      throw Error(ErrorKind::usage, "GLB holds floats, too small for coordinates like " + shortest(value) +
                                        "; ask for PLY, OBJ or OFF");
    }
  }
}

void refuse_glb_size(std::uint64_t faces) {
  throw Error(ErrorKind::usage, "GLB holds 4 GiB, too little for " + grouped(faces) +
                                    " faces; ask for fewer (about 230 million fit, more with --compress "
                                    "meshopt), or for PLY, OBJ, OFF or STL");
}

}  // namespace winnow
