// GLB as it is: one primitive, vertices with what they carry beside each other.
#include "write/append.hpp"
#include "write/coarse_floats.hpp"
#include "write/formats.hpp"
#include "write/glb_layout.hpp"
#include "write/glb_motion.hpp"
#include "write/vertex_colors.hpp"

#include <string>

namespace winnow {

namespace {

class GlbEncoder final : public MeshEncoder {
 public:
  explicit GlbEncoder(const Encoding& encoding, const GlbMotion* motion = nullptr)
      : encoding_(encoding), motion_(motion) {}

  [[nodiscard]] std::string header(const MeshShape& shape) const override {
    // Each count by itself first: their product must not overflow.
    if (shape.vertices > UINT32_MAX || shape.faces > UINT32_MAX) refuse_glb_size(shape.faces);
    check_floats(shape.box);
    const GlbLayout layout(shape, encoding_);
    const Box box = motion_ != nullptr ? motion_->at_rest : written_box(shape.box, layout);
    const MeshBlock whole{shape.vertices, shape.faces, box};
    std::string text;
    emit_glb_head(
        shape, layout, {&whole, 1}, false, [&](std::string_view part) { text += part; }, motion_);
    return text;
  }

  void vertices(const MeshShape& shape, std::uint64_t /*first*/,
                std::span<const MeshVertex> vertices, std::vector<std::byte>& out) const override {
    append_glb_vertices(shape, GlbLayout(shape, encoding_), vertices, out);
  }

  void faces(const MeshShape& shape, std::uint64_t /*first*/, std::span<const MeshFace> faces,
             std::span<const Corners> /*corners*/, std::vector<std::byte>& out) const override {
    const bool small = index_type_for(shape.vertices) == GlbType::uint16;
    for (const MeshFace& face : faces) {
      for (const std::uint64_t vertex : face.vertex) {
        if (small) {
          append(out, static_cast<std::uint16_t>(vertex));
        } else {
          append(out, static_cast<std::uint32_t>(vertex));
        }
      }
    }
  }

  [[nodiscard]] std::string footer(const MeshShape& shape) const override {
    const std::uint64_t bytes = 3 * shape.faces * size_of(index_type_for(shape.vertices));
    return std::string(whole_words(bytes) - bytes, '\0');
  }

  [[nodiscard]] bool needs_survey() const override { return true; }
  [[nodiscard]] std::string attribute_refusal(const Attribute& attribute,
                                              std::span<const Attribute> wanted) const override {
    return refusal_but_for_colors(attribute, wanted, true);
  }
  [[nodiscard]] bool normals_apart() const override { return true; }
  [[nodiscard]] double position_error(const MeshShape& shape) const override {
    return GlbLayout(shape, encoding_).place.error();
  }

 private:
  Encoding encoding_;
  const GlbMotion* motion_;
};

}  // namespace

std::unique_ptr<MeshEncoder> make_encoder_of(const Encoding& encoding, const GlbMotion& motion) {
  return std::make_unique<GlbEncoder>(encoding, &motion);
}

const OutputFormat glb_output{
    .make = [](const Encoding& encoding) -> std::unique_ptr<MeshEncoder> {
      if (encoding.compress == Compression::meshopt) return make_packed_glb_encoder(encoding);
      return std::make_unique<GlbEncoder>(encoding);
    },
    .described =
        [](const Encoding& encoding) {
          return encoding.compress == Compression::meshopt ? "GLB, meshopt" : "GLB";
        },
    .text = TextForm::never,
    .doubles = false,
    .for_web = true};

}  // namespace winnow
