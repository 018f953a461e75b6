#include "write/moving_glb.hpp"

#include "write/glb_layout.hpp"
#include "write/glb_motion.hpp"

#include <utility>

namespace winnow {

namespace {

class MovingGlbOfFloats final : public MovingGlb {
 public:
  MovingGlbOfFloats(const Encoding& encoding, const MeshShape& shape, const Box& first,
                    std::size_t targets, std::vector<MorphClip> clips)
      : layout_(shape, encoding),
        colors_(shape.attributes),
        motion_{shape.normals,
                layout_.color ? layout_.color->components : 0,
                shape.vertices,
                written_box(first, layout_),
                std::vector<Box>(targets),
                std::move(clips)},
        encoder_(make_encoder_of(encoding, motion_)) {}

  void measure(std::size_t target, std::span<const MeshVertex> first,
               std::span<const MeshVertex> own) override {
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto [x, y, z] = glb_move(layout_, colors_, first[i], own[i]).position;
      motion_.moves[target].add(Point{x, y, z});
    }
  }
  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  void append_target(std::span<const MeshVertex> first, std::span<const MeshVertex> own,
                     std::vector<std::byte>& out) const override {
    for (std::size_t i = 0; i < own.size(); ++i)
      append_move(motion_, glb_move(layout_, colors_, first[i], own[i]), out);
  }
  void append_clips(std::vector<std::byte>& out) const override {
    winnow::append_clips(motion_, out);
  }

 private:
  GlbLayout layout_;
  VertexColors colors_;
  GlbMotion motion_;
  std::unique_ptr<MeshEncoder> encoder_;
};

}  // namespace

std::unique_ptr<MovingGlb> make_moving_glb(const Encoding& encoding, const MeshShape& shape,
                                           const Box& first, std::size_t targets,
                                           std::vector<MorphClip> clips) {
  return std::make_unique<MovingGlbOfFloats>(encoding, shape, first, targets, std::move(clips));
}

}  // namespace winnow
