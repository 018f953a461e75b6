// In the place of the encoders of GLB in a library without that part.
#include <winnow/parts.hpp>

#include "write/formats.hpp"
#include "write/moving_glb.hpp"

namespace winnow {

const OutputFormat glb_output{
    .make = [](const Encoding& /*encoding*/) -> std::unique_ptr<MeshEncoder> {
      throw MissingPart(Part::gltf, "GLB cannot be written");
    },
    .text = TextForm::never,
    .doubles = false,
    .for_web = true};

std::unique_ptr<MovingGlb> make_moving_glb(const Encoding& /*encoding*/, const MeshShape& /*shape*/,
                                           const Box& /*first*/, std::size_t /*targets*/,
                                           std::vector<MorphClip> /*clips*/) {
  throw MissingPart(Part::gltf, "GLB cannot be written");
}

}  // namespace winnow
