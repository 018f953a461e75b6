// In the place of compare.cpp in a library without that part.
#include <winnow/compare.hpp>
#include <winnow/parts.hpp>

namespace winnow {

CompareReport compare(Context& /*context*/, const std::string& /*original*/,
                      const std::string& /*simplified*/, const CompareOptions& /*options*/) {
  throw MissingPart(Part::compare, "Meshes cannot be compared");
}

}  // namespace winnow
