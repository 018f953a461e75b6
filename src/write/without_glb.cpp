// In the place of the encoders of GLB in a library without that part.
#include <winnow/parts.hpp>

#include "write/formats.hpp"

namespace winnow {

const OutputFormat glb_output{
    .make = [](const Encoding& /*encoding*/) -> std::unique_ptr<MeshEncoder> {
      throw MissingPart(Part::gltf, "GLB cannot be written");
    },
    .text = TextForm::never,
    .doubles = false,
    .for_web = true};

}  // namespace winnow
