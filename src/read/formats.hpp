// The formats that can be read. A new one is a new file, a line here and a line in open_reader.cpp.
#pragma once

#include "read/mesh_reader.hpp"

#include <string_view>

namespace winnow {

std::unique_ptr<MeshReader> open_ply(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                                     const AttributeWish& wish);
InputOutlook look_at_ply(ByteSource& source, const AttributeWish& wish);

// OBJ. Here and below, is_...() says whether a text begins like one, as far as `head` shows, and
// offer_of_...() what its vertices carry.
bool is_obj(std::string_view head);
AttributeOffer offer_of_obj(std::string_view head);
std::unique_ptr<MeshReader> open_obj(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                                     const AttributeWish& wish);

// OFF as text, with or without colours, normals and the like.
bool is_off(std::string_view head);
AttributeOffer offer_of_off(std::string_view head);
std::unique_ptr<MeshReader> open_off(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                                     const AttributeWish& wish);

// .m, vertices and faces with numbers of their own.
bool is_m(std::string_view head);
std::unique_ptr<MeshReader> open_m(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                                   const AttributeWish& wish);

// glTF 2.0, as GLB or as JSON. The source must be seekable; the offer is that of the whole JSON, also of a
// pipe.
bool is_gltf(std::string_view head);
AttributeOffer offer_of_gltf(Job& job, ByteSource& source);
std::unique_ptr<MeshReader> open_gltf(Job& job, std::unique_ptr<ByteSource> source,
                                      const ReaderMemory& memory, const AttributeWish& wish);

// STL, binary or ASCII, by content.
std::unique_ptr<MeshReader> open_stl(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory);
InputOutlook look_at_stl(ByteSource& source);

}  // namespace winnow
