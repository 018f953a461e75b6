// The formats that can be read. A new one is a new file, a line here and a line in open_reader.cpp.
#pragma once

#include "read/mesh_reader.hpp"

#include <string_view>

namespace winnow {

std::unique_ptr<MeshReader> open_ply(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory, const AttributeRequest& wish);
InputProbe probe_ply(ByteSource& source, const AttributeRequest& wish);

// How surely a text is one of a format, as far as its first bytes show.
enum class TextMatch {
  none,
  named,  // it may be one, which the name of the file has to say
  later,  // statements of the format stand behind lines that it does not know
  first   // the first statement is one of the format
};
bool match_ply(std::string_view head);  // surely, or not at all

// OBJ. Here and below, match_...() says how surely a text is one, and offer_of_...() what its
// vertices carry.
TextMatch match_obj(std::string_view head);
AvailableAttributes offer_of_obj(std::string_view head);
std::unique_ptr<MeshReader> open_obj(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory, const AttributeRequest& wish);

// OFF as text, with or without colours, normals and the like.
TextMatch match_off(std::string_view head);
AvailableAttributes offer_of_off(std::string_view head);
std::unique_ptr<MeshReader> open_off(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory, const AttributeRequest& wish);

// .m, vertices and faces with numbers of their own.
TextMatch match_m(std::string_view head);
std::unique_ptr<MeshReader> open_m(Job& job, std::unique_ptr<ByteSource> source,
                                   const ReaderMemory& memory, const AttributeRequest& wish);

// glTF 2.0, as GLB or as JSON. The source must be seekable; the offer is that of the whole JSON,
// also of a pipe.
TextMatch match_gltf(std::string_view head);
AvailableAttributes offer_of_gltf(Job& job, ByteSource& source);
std::unique_ptr<MeshReader> open_gltf(Job& job, std::unique_ptr<ByteSource> source,
                                      const ReaderMemory& memory, const AttributeRequest& wish);

// STL, binary or ASCII, by content. Where it is not `asked` for, by option or by name, a binary one
// must have the size that its count of faces says.
TextMatch match_stl(std::string_view head);
bool has_size_of_binary_stl(ByteSource& source);
std::unique_ptr<MeshReader> open_stl(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory, bool asked);
InputProbe probe_stl(ByteSource& source, bool asked);

// What the name of a file says; automatic where it says nothing.
Format format_called(std::string_view name);

}  // namespace winnow
