#include <winnow/parts.hpp>

namespace winnow {

namespace {

constexpr bool has_gltf = WINNOW_HAS_GLTF;
constexpr bool has_compare = WINNOW_HAS_COMPARE;

}  // namespace

bool has_part(Part part) {
  return part == Part::gltf ? has_gltf : has_compare;
}

MissingPart::MissingPart(Part part, const std::string& failed)
    : Error(ErrorKind::failed,
            failed + ": this winnow was built without " +
                (part == Part::gltf ? "glTF; build it with -DWINNOW_GLTF=ON"
                                    : "comparing; build it with -DWINNOW_COMPARE=ON")),
      part_(part) {}

}  // namespace winnow
