// GLB as it is: one primitive, vertices with their normals beside each other, indices of 32 bits.
#include "write/append.hpp"
#include "write/glb_layout.hpp"
#include "write/vertex_colors.hpp"

#include <string>

namespace winnow {

namespace {

class GlbEncoder final : public MeshEncoder {
 public:
  [[nodiscard]] std::string header(const MeshShape& shape) const override {
    // Each count by itself first: their product must not overflow.
    if (shape.vertices > UINT32_MAX || shape.faces > UINT32_MAX) refuse_glb_size(shape.faces);
    check_floats(shape.box);
    const MeshBlock whole{shape.vertices, shape.faces, written_box(shape.box, glb_offset(shape))};
    std::string text;
    emit_glb_head(shape, {&whole, 1}, false, [&](std::string_view part) { text += part; });
    return text;
  }

  void vertices(const MeshShape& shape, std::span<const MeshVertex> vertices,
                std::vector<std::byte>& out) const override {
    append_glb_vertices(shape, glb_offset(shape), vertices, out);
  }

  void faces(const MeshShape& /*shape*/, std::span<const MeshFace> faces,
             std::span<const Corners> /*corners*/, std::vector<std::byte>& out) const override {
    for (const MeshFace& face : faces) {
      for (const std::uint64_t vertex : face.vertex) append(out, static_cast<std::uint32_t>(vertex));
    }
  }

  [[nodiscard]] bool needs_box() const override { return true; }
  [[nodiscard]] std::string attribute_refusal(const Attribute& attribute,
                                              std::span<const Attribute> wanted) const override {
    return refusal_but_for_colors(attribute, wanted, true);
  }
  [[nodiscard]] bool normals_apart() const override { return true; }
};

}  // namespace

std::unique_ptr<MeshEncoder> make_glb_encoder() {
  return std::make_unique<GlbEncoder>();
}

}  // namespace winnow
