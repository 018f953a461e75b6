// .m, the text format of Hugues Hoppe's mesh programs: vertices and faces count from 1. What a
// vertex carries stands in braces: {normal=(x y z) rgb=(r g b)}, colours from 0 to 1.
#include "write/append_text.hpp"
#include "write/formats.hpp"
#include "write/vertex_colors.hpp"

namespace winnow {

namespace {

class MEncoder final : public MeshEncoder {
 public:
  [[nodiscard]] std::string header(const MeshShape& /*shape*/) const override { return {}; }

  void vertices(const MeshShape& shape, std::uint64_t first, std::span<const MeshVertex> vertices,
                std::vector<std::byte>& out) const override {
    const VertexColors colors(shape.attributes);
    for (const MeshVertex& vertex : vertices) {
      append_text(out, "Vertex ");
      append_number(out, ++first);
      append_text(out, " ");
      append_position(out, vertex.position, shape.double_positions);
      if (shape.normals) {
        append_text(out, " {normal=(");
        append_triple(out, vertex.normal);
      }
      if (colors.any()) {
        append_text(out, shape.normals ? ") rgb=(" : " {rgb=(");
        append_triple(out, colors.rgb(vertex));
      }
      append_text(out, shape.normals || colors.any() ? ")}\n" : "\n");
    }
  }

  void faces(const MeshShape& /*shape*/, std::uint64_t first, std::span<const MeshFace> faces,
             std::span<const Corners> /*corners*/, std::vector<std::byte>& out) const override {
    for (const MeshFace& face : faces) {
      append_text(out, "Face ");
      append_number(out, ++first);
      append_text(out, " ");
      append_triple(out, std::array{face.vertex[0] + 1, face.vertex[1] + 1, face.vertex[2] + 1});
      append_text(out, "\n");
    }
  }

  [[nodiscard]] std::string attribute_refusal(const Attribute& attribute,
                                              std::span<const Attribute> wanted) const override {
    return refusal_but_for_colors(attribute, wanted, false);
  }
  [[nodiscard]] bool normals_apart() const override { return true; }
};

}  // namespace

const OutputFormat m_output{
    .make = [](const Encoding& /*encoding*/) -> std::unique_ptr<MeshEncoder> {
      return std::make_unique<MEncoder>();
    }};

}  // namespace winnow
