// In the place of read/gltf in a library without that part.
#include <winnow/parts.hpp>

#include "io/byte_source.hpp"
#include "read/formats.hpp"

namespace winnow {

namespace {

[[noreturn]] void refuse(const ByteSource& source) {
  throw MissingPart(Part::gltf, "'" + source.name() + "' cannot be read");
}

}  // namespace

AvailableAttributes offer_of_gltf(Job& /*job*/, ByteSource& source) {
  refuse(source);
}

std::unique_ptr<MeshReader> open_gltf(Job& /*job*/, std::unique_ptr<ByteSource> source,
                                      const ReaderMemory& /*memory*/,
                                      const AttributeRequest& /*wish*/) {
  refuse(*source);
}

}  // namespace winnow
