// OFF, by the manual of Geomview: counts, vertices, faces; NOFF where vertices have normals.
#include "write/append_text.hpp"
#include "write/mesh_encoder.hpp"

namespace winnow {

namespace {

class OffEncoder final : public MeshEncoder {
 public:
  [[nodiscard]] std::string header(const MeshShape& shape) const override {
    std::string text = shape.normals ? "NOFF\n" : "OFF\n";
    if (!shape.comment.empty()) text += "# " + shape.comment + "\n";
    return text + std::to_string(shape.vertices) + " " + std::to_string(shape.faces) + " 0\n";
  }

  void vertices(const MeshShape& shape, std::span<const MeshVertex> vertices,
                std::vector<std::byte>& out) const override {
    append_lines(out, shape, vertices);
  }

  void faces(const MeshShape& /*shape*/, std::span<const MeshFace> faces,
             std::span<const Corners> /*corners*/, std::vector<std::byte>& out) const override {
    append_lines(out, faces);
  }
};

}  // namespace

std::unique_ptr<MeshEncoder> make_off_encoder() {
  return std::make_unique<OffEncoder>();
}

}  // namespace winnow
