// Wavefront OBJ, by appendix B1 of the Advanced Visualizer manual: indices count from 1.
#include "write/append_text.hpp"
#include "write/mesh_encoder.hpp"

namespace winnow {

namespace {

class ObjEncoder final : public MeshEncoder {
 public:
  [[nodiscard]] std::string header(const MeshShape& shape) const override {
    std::string text;
    if (!shape.comment.empty()) text += "# " + shape.comment + "\n";
    return text + "# " + std::to_string(shape.vertices) + " vertices, " + std::to_string(shape.faces) +
           " faces\n";
  }

  void vertices(const MeshShape& shape, std::span<const MeshVertex> vertices,
                std::vector<std::byte>& out) const override {
    for (const MeshVertex& vertex : vertices) {
      append_text(out, "v ");
      append_position(out, vertex.position, shape.double_positions);
      if (shape.normals) {
        append_text(out, "\nvn ");
        append_triple(out, vertex.normal);
      }
      append_text(out, "\n");
    }
  }

  void faces(const MeshShape& shape, std::span<const MeshFace> faces, std::span<const Corners> /*corners*/,
             std::vector<std::byte>& out) const override {
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
};

}  // namespace

std::unique_ptr<MeshEncoder> make_obj_encoder() {
  return std::make_unique<ObjEncoder>();
}

}  // namespace winnow
