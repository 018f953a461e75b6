#include <winnow/parts.hpp>

namespace winnow {

bool has_part(Part part) {
  return part == Part::gltf ? WINNOW_HAS_GLTF : WINNOW_HAS_COMPARE;
}

MissingPart::MissingPart(Part part, const std::string& failed)
    : Error(ErrorKind::failed,
            failed + ": this winnow was built without " +
                (part == Part::gltf ? "glTF; build it with -DWINNOW_GLTF=ON"
                                    : "comparing; build it with -DWINNOW_COMPARE=ON")),
      part_(part) {}

}  // namespace winnow
