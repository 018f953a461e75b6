// Binary glTF 2.0 (Khronos Group; ISO/IEC 12113): a header, a chunk of JSON, a chunk of vertices
// and indices.
#include "write/glb_layout.hpp"

#include <winnow/error.hpp>

#include "base/srgb.hpp"
#include "base/text.hpp"
#include "base/vector.hpp"
#include "write/append.hpp"
#include "write/glb_motion.hpp"
#include "write/glb_text.hpp"
#include "write/vertex_colors.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace winnow {

namespace {

const std::string packing = "EXT_meshopt_compression";
const std::string quantization = "KHR_mesh_quantization";

// One after the other, with commas between.
template <typename Text>
void emit_list(std::size_t count, const Emit& emit, const Text& text) {
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) emit(",");
    emit(text(i));
  }
}

// Numbers of accessors. Of each block: positions, indices and, if it has them, normals and colours.
struct Numbers {
  explicit Numbers(const GlbLayout& layout)
      : normals(layout.normal ? 1 : 0), colors(layout.color ? 1 : 0) {}

  std::size_t normals, colors;
  [[nodiscard]] std::size_t first(std::size_t block) const {
    return (2 + normals + colors) * block;
  }
  [[nodiscard]] std::string position(std::size_t block) const { return glb_number(first(block)); }
  [[nodiscard]] std::string indices(std::size_t block) const {
    return glb_number(first(block) + 1);
  }
  [[nodiscard]] std::string normal(std::size_t block) const { return glb_number(first(block) + 2); }
  [[nodiscard]] std::string color(std::size_t block) const {
    return glb_number(first(block) + 2 + normals);
  }
};

std::string type_of(GlbType type) {
  return R"("componentType":)" + glb_number(static_cast<unsigned>(type));
}

std::string vertex_accessor(std::size_t block, const GlbPart& part, const MeshBlock& of,
                            bool normalized) {
  return R"({"bufferView":)" + glb_number(2 * block) + R"(,"byteOffset":)" +
         glb_number(part.offset) + "," + type_of(part.type) +
         (normalized && part.type != GlbType::float32 ? R"(,"normalized":true)" : "") +
         R"(,"count":)" + glb_number(of.vertices) + R"(,"type":"VEC)" +
         glb_number(part.components) + "\"";
}

std::string accessors_of(const GlbLayout& layout, std::size_t block, const MeshBlock& of) {
  std::string text = vertex_accessor(block, layout.position, of, false) + R"(,"min":)" +
                     glb_list(of.box.low) + R"(,"max":)" + glb_list(of.box.high) +
                     R"(},{"bufferView":)" + glb_number(2 * block + 1) + "," +
                     type_of(index_type_for(of.vertices)) + R"(,"count":)" +
                     glb_number(3 * of.faces) + R"(,"type":"SCALAR"})";
  for (const std::optional<GlbPart>& part : {layout.normal, layout.color}) {
    if (part) text += "," + vertex_accessor(block, *part, of, true) + "}";
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
                     glb_number(view.begin) + R"(,"byteLength":)" + glb_number(view.bytes);
  if (view.vertices) text += R"(,"byteStride":)" + glb_number(view.stride);
  text += std::string(R"(,"target":)") + (view.vertices ? "34962" : "34963");
  if (packed) {
    text += R"(,"extensions":{")" + packing + R"(":{"buffer":0,"byteOffset":)" +
            glb_number(view.packed_begin) + R"(,"byteLength":)" + glb_number(view.packed_bytes) +
            R"(,"byteStride":)" + glb_number(view.stride) + R"(,"count":)" +
            glb_number(view.count) + R"(,"mode":")" + (view.vertices ? "ATTRIBUTES" : "TRIANGLES") +
            R"("}})";
  }
  return text + "}";
}

std::uint64_t index_bytes(const MeshBlock& block) {
  return size_of(index_type_for(block.vertices));
}

std::uint64_t whole_bytes(const GlbLayout& layout, const MeshBlock& block) {
  return block.vertices * layout.stride + whole_words(block.faces * 3 * index_bytes(block));
}

std::uint64_t packed_bytes(const MeshBlock& block) {
  return whole_words(block.vertex_bytes) + whole_words(block.index_bytes);
}

// Dull, as scans and terrain are; of an open surface both sides are seen.
std::string material_of(const MeshShape& shape) {
  return std::string(R"({"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.8})") +
         (shape.closed ? "" : R"(,"doubleSided":true)") + "}";
}

std::string extensions_of(const GlbLayout& layout, bool packed) {
  std::string names;
  if (layout.place.step) names += "\"" + quantization + "\"";
  if (packed) names += (names.empty() ? "\"" : ",\"") + packing + "\"";
  if (names.empty()) return "";
  return R"("extensionsUsed":[)" + names + R"(],"extensionsRequired":[)" + names + "],";
}

// By the specification a node scales first, then turns, then moves.
std::string transform_of(const GlbPlace& place) {
  std::string text;
  const auto [x, y, z] = place.offset;
  const Point moved = place.z_up ? Point{x, z, 0 - y} : place.offset;
  if (moved != Point{}) text += R"(,"translation":)" + glb_list(moved);
  // A quarter turn around x takes z to y.
  if (place.z_up) text += R"(,"rotation":[-0.7071067811865476,0,0,0.7071067811865476])";
  if (place.step) text += R"(,"scale":)" + glb_list({*place.step, *place.step, *place.step});
  return text;
}

void emit_json(const MeshShape& shape, const GlbLayout& layout, std::span<const MeshBlock> blocks,
               bool packed, const GlbMotion* motion, const Emit& emit) {
  const Numbers numbers(layout);
  const std::size_t of_motion = numbers.first(blocks.size());
  emit(R"({"asset":{"version":"2.0","generator":"winnow"},)");
  emit(extensions_of(layout, packed));
  emit(R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" + transform_of(layout.place) +
       R"(}],"materials":[)" + material_of(shape) + R"(],"meshes":[{"primitives":[)");
  emit_list(blocks.size(), emit, [&](std::size_t i) {
    emit(R"({"attributes":{"POSITION":)" + numbers.position(i) +
         (numbers.normals > 0 ? R"(,"NORMAL":)" + numbers.normal(i) : "") +
         (numbers.colors > 0 ? R"(,"COLOR_0":)" + numbers.color(i) : "") + R"(},"indices":)" +
         numbers.indices(i));
    if (motion != nullptr) emit_glb_targets(*motion, of_motion, emit);
    return R"(,"material":0})";
  });
  emit(R"(]}],"accessors":[)");
  emit_list(blocks.size(), emit, [&](std::size_t i) { return accessors_of(layout, i, blocks[i]); });
  if (motion != nullptr) emit_motion_accessors(*motion, 2 * blocks.size(), emit);
  emit(R"(],"bufferViews":[)");
  View view;
  emit_list(blocks.size(), emit, [&](std::size_t i) {
    const MeshBlock& block = blocks[i];
    const auto next = [&](bool vertices, std::uint64_t count, std::uint64_t stride,
                          std::uint64_t bytes) {
      view = {whole_words(view.begin + view.bytes),
              count * stride,
              whole_words(view.packed_begin + view.packed_bytes),
              bytes,
              stride,
              count,
              vertices};
      return view_of(view, packed);
    };
    const std::string vertices = next(true, block.vertices, layout.stride, block.vertex_bytes);
    return vertices + "," + next(false, 3 * block.faces, index_bytes(block), block.index_bytes);
  });
  std::uint64_t whole = whole_words(view.begin + view.bytes);
  if (motion != nullptr) {
    emit_motion_views(*motion, whole, emit);
    whole += motion->bytes();
  }
  emit(R"(],"buffers":[{"byteLength":)" +
       glb_number(packed ? whole_words(view.packed_begin + view.packed_bytes) : whole) + "}");
  // Where the bytes would be, were they not packed: nowhere.
  if (packed)
    emit(R"(,{"byteLength":)" + glb_number(whole) + R"(,"extensions":{")" + packing +
         R"(":{"fallback":true}}})");
  emit("]");
  if (motion != nullptr) emit_glb_animations(*motion, of_motion, emit);
  emit("}");
}

}  // namespace

// No other length is allowed; for a vertex that has no normal one is as good as another.
std::array<float, 3> unit_normal(const std::array<float, 3>& normal) {
  const Point exact{normal[0], normal[1], normal[2]};
  const double square = dot(exact, exact);
  if (std::abs(square - 1) <= 1e-6) return normal;
  if (!(square > 0)) return {0, 0, 1};
  const Point of_one = unit(exact);
  return {static_cast<float>(of_one[0]), static_cast<float>(of_one[1]),
          static_cast<float>(of_one[2])};
}

Point glb_offset(const MeshShape& shape) {
  Point offset{};
  const double side = shape.box.longest_side();
  if (!shape.double_positions || shape.box.empty || !(side > 0)) return offset;
  const double step = std::ldexp(1.0, std::ilogb(side));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = shape.box.low[axis];
    const double high = shape.box.high[axis];
    if (std::max(std::abs(low), std::abs(high)) > 2 * side)
      offset[axis] = std::floor(low / step) * step;
  }
  return offset;
}

namespace {

// The smallest type that loses nothing of a component's, by how it is stored.
GlbType type_for(const Attribute& component) {
  if (component.type == NumberType::uint8 && component.kind != AttributeKind::color)
    return GlbType::uint8;
  if (component.type == NumberType::uint8) return GlbType::uint16;
  if (component.type == NumberType::uint16 && component.kind != AttributeKind::color)
    return GlbType::uint16;
  return GlbType::float32;
}

GlbType type_for_colors(std::span<const Attribute> attributes) {
  GlbType type = GlbType::uint8;
  for (const Attribute& attribute : attributes) {
    if (is_color_component(attribute)) type = std::max(type, type_for(attribute));
  }
  return type;
}

// A number from 0, or -1, to 1.
void append_part(std::vector<std::byte>& out, double value, GlbType type) {
  switch (type) {
    case GlbType::int8:
      return append(out, static_cast<std::int8_t>(std::nearbyint(INT8_MAX * value)));
    case GlbType::uint8:
      return append(out, static_cast<std::uint8_t>(std::nearbyint(UINT8_MAX * value)));
    case GlbType::uint16:
      return append(out, static_cast<std::uint16_t>(std::nearbyint(UINT16_MAX * value)));
    default:
      return append(out, static_cast<float>(value));
  }
}

GlbPlace place_of(const MeshShape& shape, const Encoding& encoding) {
  GlbPlace place;
  place.z_up = encoding.up == UpAxis::z;
  if (!encoding.quantize) {
    place.offset = glb_offset(shape);
    return place;
  }
  place.offset = shape.box.low;
  place.highest = std::ldexp(1, static_cast<int>(*encoding.quantize)) - 1;
  const double side = shape.box.empty ? 0 : shape.box.longest_side();
  place.step = side > 0 ? side / place.highest : 1;
  return place;
}

}  // namespace

std::uint64_t size_of(GlbType type) {
  switch (type) {
    case GlbType::int8:
    case GlbType::uint8:
      return 1;
    case GlbType::uint16:
      return 2;
    default:
      return 4;
  }
}

GlbLayout::GlbLayout(const MeshShape& shape, const Encoding& encoding)
    : place(place_of(shape, encoding)) {
  const auto add = [&](GlbType type, unsigned components) {
    const GlbPart part{type, components, stride};
    stride = whole_words(stride + components * size_of(type));
    return part;
  };
  position = add(encoding.quantize ? GlbType::uint16 : GlbType::float32, 3);
  if (shape.normals) normal = add(encoding.quantize ? GlbType::int8 : GlbType::float32, 3);
  const VertexColors colors(shape.attributes);
  if (colors.any()) color = add(type_for_colors(shape.attributes), colors.alpha() ? 4 : 3);
}

double GlbPlace::error() const {
  return step ? std::sqrt(3.0) / 2 * *step : 0;
}

Point written_position(const Point& position, const GlbLayout& layout) {
  Point written = position - layout.place.offset;
  for (double& x : written) {
    x = layout.place.step
            ? std::clamp(std::nearbyint(x / *layout.place.step), 0.0, layout.place.highest)
            : nearest_float(x);
  }
  return written;
}

void append_glb_vertices(const MeshShape& shape, const GlbLayout& layout,
                         std::span<const MeshVertex> vertices, std::vector<std::byte>& out) {
  const VertexColors colors(shape.attributes);
  for (const MeshVertex& vertex : vertices) {
    for (const double x : written_position(vertex.position, layout)) {
      if (layout.place.step) {
        append(out, static_cast<std::uint16_t>(x));
      } else {
        append(out, static_cast<float>(x));
      }
    }
    out.resize(whole_words(out.size()));
    if (layout.normal) {
      for (const float along : unit_normal(vertex.normal))
        append_part(out, along, layout.normal->type);
      out.resize(whole_words(out.size()));
    }
    for (unsigned i = 0; layout.color && i < layout.color->components; ++i) {
      const double component = std::clamp(colors.component(vertex, i), 0.0, 1.0);
      append_part(out, i < 3 ? light_of_component(component) : component, layout.color->type);
    }
    out.resize(whole_words(out.size()));
  }
}

Box written_box(const Box& box, const GlbLayout& layout) {
  return {written_position(box.low, layout), written_position(box.high, layout), box.empty};
}

void emit_glb_head(const MeshShape& shape, const GlbLayout& layout,
                   std::span<const MeshBlock> blocks, bool packed, const Emit& emit,
                   const GlbMotion* motion) {
  constexpr std::uint64_t header_bytes = 12;
  constexpr std::uint64_t chunk_header_bytes = 8;
  // Twice: its length stands before it.
  std::uint64_t json_bytes = 0;
  emit_json(shape, layout, blocks, packed, motion,
            [&](std::string_view text) { json_bytes += text.size(); });
  const std::uint64_t blanks = whole_words(json_bytes) - json_bytes;
  json_bytes += blanks;
  std::uint64_t binary_bytes = 0;
  for (const MeshBlock& block : blocks)
    binary_bytes += packed ? packed_bytes(block) : whole_bytes(layout, block);
  if (motion != nullptr) binary_bytes += motion->bytes();
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
  emit_json(shape, layout, blocks, packed, motion, emit);
  emit(std::string(blanks, ' '));
  head.clear();
  append(head, static_cast<std::uint32_t>(binary_bytes));
  append(head, std::array{'B', 'I', 'N', '\0'});
  emit_bytes(head);
}

void refuse_glb_size(std::uint64_t faces) {
  throw Error(ErrorKind::usage,
              "GLB holds 4 GiB, too little for " + grouped(faces) +
                  " faces; ask for fewer (about 230 million fit, more with `compress` "
                  "meshopt), or for PLY, OBJ, OFF or STL");
}

}  // namespace winnow
