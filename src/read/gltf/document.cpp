#include "read/gltf/document.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace winnow {

std::size_t size_of(GltfType type) {
  constexpr std::array<std::size_t, 6> sizes{1, 1, 2, 2, 4, 4};
  return sizes.at(static_cast<std::size_t>(type));
}

namespace {

class Parser {
 public:
  Parser(std::string_view text, const std::string& name) : json_(text, name) {}

  GltfDocument document() {
    check_version();
    check_extensions();
    for (const Value& buffer : json_.list("buffers")) add_buffer(buffer);
    for (const Value& view : json_.list("bufferViews")) add_view(view);
    for (const Value& accessor : json_.list("accessors")) add_accessor(accessor);
    for (const Value& mesh : json_.list("meshes")) add_mesh(mesh);
    const Value& relative = json_.member(json_.member(json_.root(), "extensions"), "CESIUM_RTC");
    if (!relative.is_null()) document_.center = json_.numbers<3>(relative, "center");
    if (!json_.list("skins").empty()) note("skins");
    if (!json_.list("animations").empty()) note(unread_animations);
    for (const Value& animation : json_.list("animations")) add_animation(animation);
    document_.placed = place_meshes(json_, document_.meshes.size(), document_.accessors.size(),
                                    document_.center.value_or(Point{}));
    return std::move(document_);
  }

 private:
  using Value = GltfJson::Value;

  [[noreturn]] void fail(const std::string& what) const { json_.fail(what); }

  void check_version() const {
    const std::string version = GltfJson::text(json_.member(json_.root(), "asset"), "version");
    if (!version.starts_with("2."))
      fail("it is glTF '" + GltfJson::one_line(version) + "'; version 2 is read");
  }

  // What is required must be known, by the specification: what is read, and what says nothing of
  // positions.
  void check_extensions() const {
    constexpr std::array<std::string_view, 16> known{"KHR_mesh_quantization",
                                                     "EXT_meshopt_compression",
                                                     "KHR_materials_",
                                                     "KHR_texture_",
                                                     "EXT_texture_",
                                                     "MSFT_texture_",
                                                     "KHR_lights_",
                                                     "EXT_lights_",
                                                     "KHR_animation",
                                                     "KHR_xmp",
                                                     "EXT_mesh_features",
                                                     "EXT_structural_metadata",
                                                     "KHR_techniques",
                                                     "KHR_node_",
                                                     "EXT_mesh_gpu_instancing",
                                                     "CESIUM_RTC"};
    for (const Value& extension : json_.list("extensionsRequired")) {
      const std::string name = extension.is_string() ? extension.get<std::string>() : std::string();
      if (name == "KHR_draco_mesh_compression") fail_draco();
      if (std::none_of(known.begin(), known.end(),
                       [&](std::string_view one) { return name.starts_with(one); }))
        fail("it requires the extension '" + GltfJson::one_line(name) + "', which is not read");
    }
  }
  [[noreturn]] void fail_draco() const {
    fail(
        "its triangles are compressed with Draco, which is not read; decompress it first, or "
        "convert it to "
        "PLY");
  }

  void add_buffer(const Value& json) {
    json_.check_object(json, "buffers");
    GltfBuffer buffer;
    buffer.bytes = json_.required(json, "byteLength");
    const Value& uri = GltfJson::find(json, "uri");
    if (uri.is_string()) buffer.uri = uri.get<std::string>();
    document_.buffers.push_back(std::move(buffer));
  }

  void add_view(const Value& json) {
    json_.check_object(json, "bufferViews");
    GltfView view;
    view.buffer = json_.required_index(json, "buffer", document_.buffers.size());
    view.offset = json_.count(json, "byteOffset", 0);
    view.bytes = json_.required(json, "byteLength");
    view.stride = json_.count(json, "byteStride", 0);
    if (view.stride > 65535) fail("a 'byteStride' is larger than any element");
    const Value& packed = json_.member(json_.member(json, "extensions"), "EXT_meshopt_compression");
    if (packed.is_object()) view.packing = packing(packed, view);
    if (!view.packing) check_fits(view.buffer, view.offset, view.bytes);
    document_.views.push_back(view);
  }

  void check_fits(std::size_t buffer, std::uint64_t offset, std::uint64_t bytes) const {
    const std::uint64_t whole = document_.buffers[buffer].bytes;
    if (offset > whole || bytes > whole - offset)
      fail("a 'bufferView' reaches behind the end of its buffer");
  }

  GltfPacking packing(const Value& json, const GltfView& view) const {
    GltfPacking packing;
    packing.buffer = json_.required_index(json, "buffer", document_.buffers.size());
    packing.offset = json_.count(json, "byteOffset", 0);
    packing.bytes = json_.required(json, "byteLength");
    packing.count = json_.required(json, "count");
    packing.stride = json_.required(json, "byteStride");
    check_fits(packing.buffer, packing.offset, packing.bytes);
    const std::string mode = GltfJson::text(json, "mode");
    const std::string filter = GltfJson::text(json, "filter");
    using Mode = GltfPacking::Mode;
    if (mode != "ATTRIBUTES" && mode != "TRIANGLES" && mode != "INDICES")
      fail("it is packed in the mode '" + GltfJson::one_line(mode) + "', which is not known");
    packing.mode = mode == "ATTRIBUTES"  ? Mode::attributes
                   : mode == "TRIANGLES" ? Mode::triangles
                                         : Mode::indices;
    packing.filter = filter.empty() || filter == "NONE" ? GltfPacking::Filter::none
                     : filter == "OCTAHEDRAL"           ? GltfPacking::Filter::octahedral
                     : filter == "EXPONENTIAL"          ? GltfPacking::Filter::exponential
                                                        : GltfPacking::Filter::other;
    // What the decoder takes for granted.
    const bool directions = packing.filter == GltfPacking::Filter::octahedral;
    const bool good = packing.mode == Mode::attributes
                          ? packing.stride > 0 && packing.stride <= 256 &&
                                packing.stride % 4 == 0 &&
                                (!directions || packing.stride == 4 || packing.stride == 8)
                          : packing.stride == 2 || packing.stride == 4;
    // No codec makes more of a byte.
    constexpr std::uint64_t most_a_byte = 64;
    const bool filtered = packing.filter != GltfPacking::Filter::none;
    if (!good || (filtered && packing.mode != Mode::attributes) ||
        (packing.mode == Mode::triangles && packing.count % 3 != 0) ||
        packing.count > view.bytes / packing.stride ||
        packing.count * packing.stride != view.bytes || view.bytes / most_a_byte > packing.bytes) {
      fail("the sizes of a packed 'bufferView' do not fit each other");
    }
    return packing;
  }

  [[nodiscard]] GltfType type(const Value& object) const {
    switch (json_.required(object, "componentType")) {
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

  void add_accessor(const Value& json) {
    json_.check_object(json, "accessors");
    GltfAccessor accessor;
    accessor.type = type(json);
    const std::string shape = GltfJson::text(json, "type");
    accessor.components = shape == "SCALAR" ? 1 : shape == "VEC3" ? 3 : shape == "VEC4" ? 4 : 0;
    accessor.normalized = GltfJson::find(json, "normalized") == Value(true);
    accessor.count = json_.required(json, "count");
    if (!GltfJson::find(json, "bufferView").is_null()) accessor.base = slice(json);
    const Value& sparse = json_.member(json, "sparse");
    if (sparse.is_object()) {
      GltfSparse& changes = accessor.sparse.emplace();
      changes.count = json_.required(sparse, "count");
      changes.indices = slice(json_.member(sparse, "indices"));
      changes.index_type = type(json_.member(sparse, "indices"));
      changes.values = slice(json_.member(sparse, "values"));
    }
    document_.accessors.push_back(accessor);
  }

  [[nodiscard]] GltfSlice slice(const Value& object) const {
    return {json_.required_index(object, "bufferView", document_.views.size()),
            json_.count(object, "byteOffset", 0)};
  }

  void add_mesh(const Value& json) {
    json_.check_object(json, "meshes");
    std::vector<GltfPrimitive>& mesh = document_.meshes.emplace_back();
    for (const Value& primitive : json_.list(json, "primitives")) {
      json_.check_object(primitive, "primitives");
      if (!json_.member(json_.member(primitive, "extensions"), "KHR_draco_mesh_compression")
               .is_null())
        fail_draco();
      const std::uint64_t mode = json_.count(primitive, "mode", 4);
      const Value& attributes = json_.member(primitive, "attributes");
      const std::optional<std::size_t> positions = accessor(attributes, "POSITION");
      if (mode < 4 || mode > 6 || !positions) {
        ++document_.other_primitives;
        if (mode == 0 && positions) document_.other_points += document_.accessors[*positions].count;
        continue;
      }
      note_unread(primitive);
      mesh.push_back({static_cast<GltfPrimitive::Mode>(mode - 4), *positions,
                      accessor(primitive, "indices"), of_vertices(attributes, "NORMAL", *positions),
                      of_vertices(attributes, "COLOR_0", *positions),
                      targets_of(primitive, *positions)});
    }
  }

  [[nodiscard]] std::vector<GltfPrimitive::Target> targets_of(const Value& primitive,
                                                              std::size_t positions) const {
    std::vector<GltfPrimitive::Target> targets;
    for (const Value& target : json_.list(primitive, "targets")) {
      json_.check_object(target, "targets");
      targets.push_back({of_vertices(target, "POSITION", positions),
                         of_vertices(target, "NORMAL", positions),
                         of_vertices(target, "COLOR_0", positions)});
    }
    return targets;
  }

  void add_animation(const Value& json) {
    json_.check_object(json, "animations");
    const Value& samplers = json_.list(json, "samplers");
    for (const Value& channel : json_.list(json, "channels")) {
      json_.check_object(channel, "channels");
      const Value& target = json_.member(channel, "target");
      const bool of_node = !GltfJson::find(target, "node").is_null();
      if (!of_node || GltfJson::text(target, "path") != "weights") {
        document_.weights_alone = false;
        continue;
      }
      const Value& sampler = samplers[json_.required_index(channel, "sampler", samplers.size())];
      json_.check_object(sampler, "samplers");
      const std::string between = GltfJson::text(sampler, "interpolation");
      document_.weights.push_back(
          {GltfJson::text(json, "name"),
           json_.required_index(target, "node", json_.list("nodes").size()),
           json_.required_index(sampler, "input", document_.accessors.size()),
           json_.required_index(sampler, "output", document_.accessors.size()),
           between == "STEP"          ? MorphClip::Between::step
           : between == "CUBICSPLINE" ? MorphClip::Between::cubic
                                      : MorphClip::Between::linear});
    }
  }

  [[nodiscard]] std::optional<std::size_t> accessor(const Value& object, const char* key) const {
    const Value& value = GltfJson::find(object, key);
    if (value.is_null()) return {};
    return json_.index_into(value, key, document_.accessors.size());
  }

  // One for each position, as the specification wants it.
  [[nodiscard]] std::optional<std::size_t> of_vertices(const Value& attributes, const char* key,
                                                       std::size_t positions) const {
    const std::optional<std::size_t> found = accessor(attributes, key);
    if (found && document_.accessors[*found].count != document_.accessors[positions].count) {
      fail("a '" + std::string(key) + "' has " + grouped(document_.accessors[*found].count) +
           " elements for " + grouped(document_.accessors[positions].count) +
           " positions; the file is damaged, or was written by a program that is wrong");
    }
    return found;
  }

  void note(const char* what) {
    if (std::find(document_.unread.begin(), document_.unread.end(), what) == document_.unread.end())
      document_.unread.emplace_back(what);
  }

  void note_unread(const Value& primitive) {
    for (const auto& [name, number] : json_.member(primitive, "attributes").items()) {
      if (name == "POSITION" || name == "NORMAL" || name == "COLOR_0") continue;
      note(name.starts_with("COLOR_")                                    ? "more colours"
           : name.starts_with("TEXCOORD_")                               ? "texture coordinates"
           : name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_") ? "skins"
                                                                         : "other attributes");
    }
    if (!json_.list(primitive, "targets").empty()) note(unread_targets);
    const Value& material = GltfJson::find(primitive, "material");
    if (!material.is_null() && !is_plain(material)) note("materials");
  }

  // Like that which every GLB gets from winnow: nothing is lost with it.
  [[nodiscard]] bool is_plain(const Value& number) const {
    const Value& materials = json_.list("materials");
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() >= materials.size())
      return false;
    Value material = materials[number.get<std::size_t>()];
    if (!material.is_object()) return false;
    material.erase("doubleSided");
    static const Value plain{
        {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.8}}}};
    return material == plain;
  }

  GltfJson json_;
  GltfDocument document_;
};

}  // namespace

GltfDocument parse_gltf(std::string_view json, const std::string& name) {
  return Parser(json, name).document();
}

std::uint64_t memory_to_parse_gltf(std::string_view json) {
  // Every value stands behind one of these, and none takes more than a node of a map with its key,
  // or than a number in a list and what is made of it while that grows.
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
