// OFF, by the manual of Geomview: counts, vertices, faces; CNOFF where vertices have colours and
// normals.
#include "write/append_text.hpp"
#include "write/formats.hpp"
#include "write/vertex_colors.hpp"

namespace winnow {

namespace {

class OffEncoder final : public MeshEncoder {
 public:
  [[nodiscard]] std::string header(const MeshShape& shape) const override {
    std::string text = VertexColors(shape.attributes).any() ? "C" : "";
    text += shape.normals ? "NOFF\n" : "OFF\n";
    if (!shape.comment.empty()) text += "# " + shape.comment + "\n";
    return text + std::to_string(shape.vertices) + " " + std::to_string(shape.faces) + " 0\n";
  }

  void vertices(const MeshShape& shape, std::uint64_t /*first*/,
                std::span<const MeshVertex> vertices, std::vector<std::byte>& out) const override {
    const VertexColors colors(shape.attributes);
    for (const MeshVertex& vertex : vertices) {
      append_geometry(out, shape, vertex);
      for (std::size_t i = 0; i < 4 && colors.any(); ++i) {
        const double component = colors.component(vertex, i);
        append_text(out, " ");
        if (colors.bytes()) {
          append_rounded(out, 255 * component, NumberType::uint8);
        } else {
          append_real(out, component);
        }
      }
      append_text(out, "\n");
    }
  }

  void faces(const MeshShape& /*shape*/, std::uint64_t /*first*/, std::span<const MeshFace> faces,
             std::span<const Corners> /*corners*/, std::vector<std::byte>& out) const override {
    append_lines(out, faces);
  }

  [[nodiscard]] std::string attribute_refusal(const Attribute& attribute,
                                              std::span<const Attribute> wanted) const override {
    return refusal_but_for_colors(attribute, wanted, true);
  }
  [[nodiscard]] bool normals_apart() const override { return true; }
};

}  // namespace

const OutputFormat off_output{
    .make = [](const Encoding& /*encoding*/) -> std::unique_ptr<MeshEncoder> {
      return std::make_unique<OffEncoder>();
    }};

}  // namespace winnow
