// Wavefront OBJ, by appendix B1 of the Advanced Visualizer manual: indices count from 1. Colours,
// which that does not know, stand behind the position, from 0 to 1, where nearly every program
// looks for them.
#include "write/append_text.hpp"
#include "write/formats.hpp"
#include "write/vertex_colors.hpp"

namespace winnow {

namespace {

class ObjEncoder final : public MeshEncoder {
 public:
  [[nodiscard]] std::string header(const MeshShape& shape) const override {
    std::string text;
    if (!shape.comment.empty()) text += "# " + shape.comment + "\n";
    return text + "# " + std::to_string(shape.vertices) + " vertices, " +
           std::to_string(shape.faces) + " faces\n";
  }

  void vertices(const MeshShape& shape, std::uint64_t /*first*/,
                std::span<const MeshVertex> vertices, std::vector<std::byte>& out) const override {
    const VertexColors colors(shape.attributes);
    for (const MeshVertex& vertex : vertices) {
      append_text(out, "v ");
      append_position(out, vertex.position, shape.double_positions);
      if (colors.any()) {
        append_text(out, " ");
        append_triple(out, colors.rgb(vertex));
      }
      if (shape.normals) {
        append_text(out, "\nvn ");
        append_triple(out, vertex.normal);
      }
      append_text(out, "\n");
    }
  }

  void faces(const MeshShape& shape, std::uint64_t /*first*/, std::span<const MeshFace> faces,
             std::span<const Corners> /*corners*/, std::vector<std::byte>& out) const override {
    for (const MeshFace& face : faces) {
      append_text(out, "f");
      for (const std::uint64_t vertex : face.vertex) {
        append_text(out, " ");
        append_number(out, vertex + 1);
        if (!shape.normals) continue;
        append_text(out, "//");
        append_number(out, vertex + 1);
      }
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

const OutputFormat obj_output{
    .make = [](const Encoding& /*encoding*/) -> std::unique_ptr<MeshEncoder> {
      return std::make_unique<ObjEncoder>();
    }};

}  // namespace winnow
