// In the place of the encoders of GLB in a library without that part.
#include <winnow/parts.hpp>

#include "write/mesh_encoder.hpp"

namespace winnow {

std::unique_ptr<MeshEncoder> make_glb_encoder(const Encoding& /*encoding*/) {
  throw MissingPart(Part::gltf, "GLB cannot be written");
}

std::unique_ptr<MeshEncoder> make_packed_glb_encoder(const Encoding& encoding) {
  return make_glb_encoder(encoding);
}

}  // namespace winnow
