// The formats that can be read. A new one is a new file, a line here and a line in open_reader.cpp.
#pragma once

#include "read/mesh_reader.hpp"

namespace winnow {

std::unique_ptr<MeshReader> open_ply(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                                     const AttributeWish& wish);
InputOutlook look_at_ply(ByteSource& source, const AttributeWish& wish);

// STL, binary or ASCII, by content.
std::unique_ptr<MeshReader> open_stl(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory);
InputOutlook look_at_stl(ByteSource& source);

}  // namespace winnow
