#include "read/gltf_document.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

namespace winnow {

std::size_t size_of(GltfType type) {
  constexpr std::array<std::size_t, 6> sizes{1, 1, 2, 2, 4, 4};
  return sizes.at(static_cast<std::size_t>(type));
}

GltfTransform operator*(const GltfTransform& a, const GltfTransform& b) {
  GltfTransform product{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      product[row][column] = a[row][0] * b[0][column] + a[row][1] * b[1][column] + a[row][2] * b[2][column] +
                             (column == 3 ? a[row][3] : 0.0);
    }
  }
  return product;
}

namespace {

using Json = nlohmann::json;

class Parser {
 public:
  Parser(std::string_view text, const std::string& name) : name_(name) {
    try {
      root_ = Json::parse(text);
    } catch (const Json::exception& error) {
      fail("its JSON is damaged: " + one_line(error.what()));
    }
    if (!root_.is_object()) fail("its JSON is no object");
  }

  GltfDocument document() {
    check_version();
    check_extensions();
    for (const Json& buffer : list("buffers")) add_buffer(buffer);
    for (const Json& view : list("bufferViews")) add_view(view);
    for (const Json& accessor : list("accessors")) add_accessor(accessor);
    for (const Json& mesh : list("meshes")) add_mesh(mesh);
    for (const Json& node : list("nodes")) add_node(node);
    place();
    return std::move(document_);
  }

 private:
  struct Node {
    std::optional<std::size_t> mesh;
    GltfTransform transform = gltf_identity;
    std::vector<std::size_t> children;
  };

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorKind::bad_input, "'" + name_ + "': " + what);
  }

  // Messages are one line, and end.
  static std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return text.substr(0, 160);
  }

  static const Json& nothing() {
    static const Json none;
    return none;
  }
  static const Json& find(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? nothing() : *found;
  }

  // What comes of a value that is not of the right kind: an empty list, an object without members.
  [[nodiscard]] const Json& list(const char* key) const { return list(root_, key); }
  [[nodiscard]] const Json& list(const Json& object, const char* key) const {
    const Json& value = find(object, key);
    if (!value.is_null() && !value.is_array()) fail("'" + std::string(key) + "' is no list");
    return value;
  }
  [[nodiscard]] const Json& member(const Json& object, const char* key) const {
    const Json& value = find(object, key);
    if (!value.is_null() && !value.is_object()) fail("'" + std::string(key) + "' is no object");
    return value;
  }

  [[nodiscard]] std::uint64_t count(const Json& value, const char* what) const {
    constexpr double most = 9.0e15;
    if (value.is_number_unsigned() && value.get<std::uint64_t>() <= std::uint64_t{9'000'000'000'000'000})
      return value.get<std::uint64_t>();
    if (value.is_number_float() && value.get<double>() >= 0 && value.get<double>() <= most &&
        value.get<double>() == std::floor(value.get<double>())) {
      return static_cast<std::uint64_t>(value.get<double>());
    }
    fail("'" + std::string(what) + "' is no count or index");
  }
  [[nodiscard]] std::uint64_t count(const Json& object, const char* key, std::uint64_t usual) const {
    const Json& value = find(object, key);
    return value.is_null() ? usual : count(value, key);
  }
  [[nodiscard]] std::uint64_t required(const Json& object, const char* key) const {
    const Json& value = find(object, key);
    if (value.is_null()) fail("'" + std::string(key) + "' is missing");
    return count(value, key);
  }
  [[nodiscard]] std::size_t index_into(const Json& value, const char* key, std::size_t size) const {
    const std::uint64_t index = count(value, key);
    if (index >= size)
      fail("'" + std::string(key) + "' names number " + std::to_string(index) + " of " +
           std::to_string(size));
    return index;
  }
  [[nodiscard]] std::size_t required_index(const Json& object, const char* key, std::size_t size) const {
    const Json& value = find(object, key);
    if (value.is_null()) fail("'" + std::string(key) + "' is missing");
    return index_into(value, key, size);
  }

  void check_object(const Json& value, const char* what) const {
    if (!value.is_object()) fail(std::string("one of its ") + what + " is no object");
  }

  static std::string text(const Json& object, const char* key) {
    const Json& value = find(object, key);
    return value.is_string() ? value.get<std::string>() : std::string();
  }

  void check_version() const {
    const std::string version = text(member(root_, "asset"), "version");
    if (!version.starts_with("2.")) fail("it is glTF '" + one_line(version) + "'; version 2 is read");
  }

  // What is required must be known, by the specification. What has no influence on positions is.
  void check_extensions() const {
    constexpr std::array<std::string_view, 14> harmless{"KHR_mesh_quantization", "EXT_meshopt_compression",
                                                        "KHR_materials_",        "KHR_texture_",
                                                        "EXT_texture_",          "MSFT_texture_",
                                                        "KHR_lights_",           "EXT_lights_",
                                                        "KHR_animation",         "KHR_xmp",
                                                        "EXT_mesh_features",     "EXT_structural_metadata",
                                                        "KHR_techniques",        "KHR_node_"};
    for (const Json& extension : list("extensionsRequired")) {
      const std::string name = extension.is_string() ? extension.get<std::string>() : std::string();
      if (name == "KHR_draco_mesh_compression") fail_draco();
      if (std::none_of(harmless.begin(), harmless.end(),
                       [&](std::string_view one) { return name.starts_with(one); }))
        fail("it requires the extension '" + one_line(name) + "', which is not read");
    }
  }
  [[noreturn]] void fail_draco() const {
    fail(
        "its triangles are compressed with Draco, which is not read; decompress it first, or convert it to "
        "PLY");
  }

  void add_buffer(const Json& json) {
    check_object(json, "buffers");
    GltfBuffer buffer;
    buffer.bytes = required(json, "byteLength");
    const Json& uri = find(json, "uri");
    if (uri.is_string()) buffer.uri = uri.get<std::string>();
    document_.buffers.push_back(std::move(buffer));
  }

  void add_view(const Json& json) {
    check_object(json, "bufferViews");
    GltfView view;
    view.buffer = required_index(json, "buffer", document_.buffers.size());
    view.offset = count(json, "byteOffset", 0);
    view.bytes = required(json, "byteLength");
    view.stride = count(json, "byteStride", 0);
    if (view.stride > 65535) fail("a 'byteStride' is larger than any element");
    const Json& packed = member(member(json, "extensions"), "EXT_meshopt_compression");
    if (packed.is_object()) view.packing = packing(packed, view);
    if (!view.packing) check_fits(view.buffer, view.offset, view.bytes);
    document_.views.push_back(view);
  }

  void check_fits(std::size_t buffer, std::uint64_t offset, std::uint64_t bytes) const {
    const std::uint64_t whole = document_.buffers[buffer].bytes;
    if (offset > whole || bytes > whole - offset) fail("a 'bufferView' reaches behind the end of its buffer");
  }

  GltfPacking packing(const Json& json, const GltfView& view) const {
    GltfPacking packing;
    packing.buffer = required_index(json, "buffer", document_.buffers.size());
    packing.offset = count(json, "byteOffset", 0);
    packing.bytes = required(json, "byteLength");
    packing.count = required(json, "count");
    packing.stride = required(json, "byteStride");
    check_fits(packing.buffer, packing.offset, packing.bytes);
    const std::string mode = text(json, "mode");
    const std::string filter = text(json, "filter");
    using Mode = GltfPacking::Mode;
    if (mode != "ATTRIBUTES" && mode != "TRIANGLES" && mode != "INDICES")
      fail("it is packed in the mode '" + one_line(mode) + "', which is not known");
    packing.mode = mode == "ATTRIBUTES"  ? Mode::attributes
                   : mode == "TRIANGLES" ? Mode::triangles
                                         : Mode::indices;
    packing.filter = filter.empty() || filter == "NONE" ? GltfPacking::Filter::none
                     : filter == "EXPONENTIAL"          ? GltfPacking::Filter::exponential
                                                        : GltfPacking::Filter::other;
    // What the decoder takes for granted.
    const bool good = packing.mode == Mode::attributes
                          ? packing.stride > 0 && packing.stride <= 256 && packing.stride % 4 == 0
                          : packing.stride == 2 || packing.stride == 4;
    if (!good || (packing.mode == Mode::triangles && packing.count % 3 != 0) ||
        packing.count > view.bytes / packing.stride || packing.count * packing.stride != view.bytes) {
      fail("the sizes of a packed 'bufferView' do not fit each other");
    }
    return packing;
  }

  [[nodiscard]] GltfType type(const Json& object) const {
    switch (required(object, "componentType")) {
      case 5120:
        return GltfType::int8;
      case 5121:
        return GltfType::uint8;
      case 5122:
        return GltfType::int16;
      case 5123:
        return GltfType::uint16;
      case 5125:
        return GltfType::uint32;
      case 5126:
        return GltfType::float32;
      default:
        fail("a 'componentType' is not known");
    }
  }

  void add_accessor(const Json& json) {
    check_object(json, "accessors");
    GltfAccessor accessor;
    accessor.type = type(json);
    const std::string shape = text(json, "type");
    accessor.components = shape == "SCALAR" ? 1 : shape == "VEC3" ? 3 : 0;
    accessor.normalized = find(json, "normalized") == Json(true);
    accessor.count = required(json, "count");
    if (!find(json, "bufferView").is_null()) accessor.base = slice(json);
    const Json& sparse = member(json, "sparse");
    if (sparse.is_object()) {
      GltfSparse& changes = accessor.sparse.emplace();
      changes.count = required(sparse, "count");
      changes.indices = slice(member(sparse, "indices"));
      changes.index_type = type(member(sparse, "indices"));
      changes.values = slice(member(sparse, "values"));
    }
    document_.accessors.push_back(accessor);
  }

  [[nodiscard]] GltfSlice slice(const Json& object) const {
    return {required_index(object, "bufferView", document_.views.size()), count(object, "byteOffset", 0)};
  }

  void add_mesh(const Json& json) {
    check_object(json, "meshes");
    std::vector<GltfPrimitive>& mesh = document_.meshes.emplace_back();
    for (const Json& primitive : list(json, "primitives")) {
      check_object(primitive, "primitives");
      if (!member(member(primitive, "extensions"), "KHR_draco_mesh_compression").is_null()) fail_draco();
      const std::uint64_t mode = count(primitive, "mode", 4);
      const Json& positions = find(member(primitive, "attributes"), "POSITION");
      if (mode < 4 || mode > 6 || positions.is_null()) {
        ++document_.other_primitives;
        continue;
      }
      note_unread(primitive);
      GltfPrimitive& added = mesh.emplace_back();
      added.mode = static_cast<GltfPrimitive::Mode>(mode - 4);
      added.positions = index_into(positions, "POSITION", document_.accessors.size());
      const Json& indices = find(primitive, "indices");
      if (!indices.is_null()) added.indices = index_into(indices, "indices", document_.accessors.size());
    }
  }

  void note_unread(const Json& primitive) {
    const auto note = [&](const char* what) {
      if (std::find(document_.unread.begin(), document_.unread.end(), what) == document_.unread.end())
        document_.unread.emplace_back(what);
    };
    for (const auto& [name, accessor] : member(primitive, "attributes").items()) {
      if (name == "POSITION") continue;
      note(name == "NORMAL"                ? "normals"
           : name.starts_with("COLOR_")    ? "colours"
           : name.starts_with("TEXCOORD_") ? "texture coordinates"
                                           : "other attributes");
    }
    if (!find(primitive, "material").is_null()) note("materials");
  }

  template <std::size_t Size>
  [[nodiscard]] std::optional<std::array<double, Size>> numbers(const Json& object, const char* key) const {
    const Json& values = list(object, key);
    if (values.is_null()) return {};
    std::array<double, Size> result{};
    if (values.size() != Size) fail("'" + std::string(key) + "' has the wrong number of values");
    for (std::size_t i = 0; i < Size; ++i) {
      if (!values[i].is_number()) fail("'" + std::string(key) + "' holds what is no number");
      result[i] = values[i].get<double>();
    }
    return result;
  }

  [[nodiscard]] GltfTransform transform(const Json& node) const {
    GltfTransform result = gltf_identity;
    if (const auto matrix = numbers<16>(node, "matrix")) {  // column after column
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column) result[row][column] = (*matrix)[4 * column + row];
      }
      return result;
    }
    const auto rotation = numbers<4>(node, "rotation");
    const auto scale = numbers<3>(node, "scale");
    const auto translation = numbers<3>(node, "translation");
    if (rotation) {
      const auto [x, y, z, w] = *rotation;
      result[0] = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0};
      result[1] = {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0};
      result[2] = {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0};
    }
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3 && scale; ++column) result[row][column] *= (*scale)[column];
      if (translation) result[row][3] = (*translation)[row];
    }
    return result;
  }

  void add_node(const Json& json) {
    check_object(json, "nodes");
    Node node;
    const Json& mesh = find(json, "mesh");
    if (!mesh.is_null()) node.mesh = index_into(mesh, "mesh", document_.meshes.size());
    node.transform = transform(json);
    for (const Json& child : list(json, "children"))
      node.children.push_back(index_into(child, "children", list("nodes").size()));
    nodes_.push_back(std::move(node));
  }

  // The default scene; without scenes every node that is nobody's child; without nodes every mesh.
  [[nodiscard]] std::vector<std::size_t> roots() const {
    std::vector<std::size_t> found;
    const Json& scenes = list("scenes");
    if (!scenes.empty()) {
      const Json& chosen = find(root_, "scene");
      const std::size_t scene = chosen.is_null() ? 0 : index_into(chosen, "scene", scenes.size());
      check_object(scenes[scene], "scenes");
      for (const Json& node : list(scenes[scene], "nodes"))
        found.push_back(index_into(node, "nodes", nodes_.size()));
      return found;
    }
    std::vector<bool> child(nodes_.size());
    for (const Node& node : nodes_) {
      for (const std::size_t one : node.children) child[one] = true;
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!child[i]) found.push_back(i);
    }
    return found;
  }

  void place() {
    if (nodes_.empty()) {
      for (std::size_t i = 0; i < document_.meshes.size(); ++i)
        document_.placed.push_back({i, gltf_identity});
      return;
    }
    struct Waiting {
      std::size_t node;
      GltfTransform parent;
    };
    std::vector<Waiting> waiting;
    const std::vector<std::size_t> first = roots();
    for (auto root = first.rbegin(); root != first.rend(); ++root) waiting.push_back({*root, gltf_identity});
    std::vector<bool> seen(nodes_.size());
    while (!waiting.empty()) {
      const Waiting next = waiting.back();
      waiting.pop_back();
      if (seen[next.node])
        fail("node " + std::to_string(next.node) + " has more than one parent, or is its own");
      seen[next.node] = true;
      const Node& node = nodes_[next.node];
      const GltfTransform to_world = next.parent * node.transform;
      if (node.mesh) document_.placed.push_back({*node.mesh, to_world});
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        waiting.push_back({*child, to_world});
    }
  }

  const std::string& name_;
  Json root_;
  GltfDocument document_;
  std::vector<Node> nodes_;
};

}  // namespace

GltfDocument parse_gltf(std::string_view json, const std::string& name) {
  return Parser(json, name).document();
}

std::uint64_t memory_to_parse_gltf(std::string_view json) {
  // Every value stands behind one of these, and none takes more than a node of a map with its key.
  constexpr std::uint64_t bytes_a_value = 192;
  std::uint64_t values = 1;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == ',' || c == ':' || c == '[' || c == '{') {
      ++values;
    }
  }
  return 3 * json.size() + bytes_a_value * values;
}

}  // namespace winnow
