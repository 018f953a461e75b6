// The formats that can be read. A new one is a file of its own and its line at the end of this one.
#pragma once

#include <winnow/format.hpp>

#include "read/mesh_reader.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace winnow {

// How surely a text is one of a format, as far as its first bytes show.
enum class TextMatch {
  none,
  named,  // it may be one, which the name of the file has to say
  later,  // statements of the format stand behind lines that it does not know
  first   // the first statement is one of the format
};

// How a source is read, and so whether a pipe has to be copied first.
enum class Reading {
  faces,          // by every pass
  vertices,       // are kept; faces are read by every pass over them
  whole,          // taken in when it is opened: see BufferedReader
  whole_by_parts  // likewise, its parts in any order: it must be seekable
};

struct InputFormat {
  Reading reading;

  // Throw Error(bad_input). `asked`: an option or the file's name says that it is one.
  std::unique_ptr<MeshReader> (*open)(Job& job, std::unique_ptr<ByteSource> source,
                                      const ReaderMemory& memory, const AttributeRequest& wish,
                                      bool asked);
  // Fills what the first bytes tell, where they tell anything.
  void (*probe)(Job& job, ByteSource& source, bool asked, InputProbe& probe) = nullptr;

  // Whether the first bytes can be of no other format; null: never.
  bool (*certain)(std::string_view head) = nullptr;
  // How surely a text is one; null: it is none.
  TextMatch (*match)(std::string_view head) = nullptr;
};

extern const InputFormat ply_input;   // any properties and elements
extern const InputFormat gltf_input;  // glTF 2.0, as GLB or as JSON
extern const InputFormat off_input;   // with or without colours, normals and the like
extern const InputFormat m_input;     // vertices and faces with numbers of their own
extern const InputFormat obj_input;
extern const InputFormat stl_input;  // binary or ASCII, by content

// Of equal matches the first counts.
inline constexpr std::array<std::pair<Format, const InputFormat*>, 6> input_formats{
    {{Format::ply, &ply_input},
     {Format::gltf, &gltf_input},
     {Format::off, &off_input},
     {Format::m, &m_input},
     {Format::obj, &obj_input},
     {Format::stl, &stl_input}}};

constexpr const InputFormat* input_format(Format format) {
  for (const auto& [known, input] : input_formats) {
    if (known == format) return input;
  }
  return nullptr;
}
static_assert(std::ranges::all_of(all_values<Format>(), [](Format format) {
  const auto listed = [format](const auto& entry) { return entry.first == format; };
  return serves(format, FormatUse::read) == std::ranges::any_of(input_formats, listed);
}));

// Of gltf_input, which is another in a library without that part.
TextMatch match_gltf(std::string_view head);

// Whether a binary STL with this header has this size: then nothing else can be told by content.
bool has_size_of_binary_stl(ByteSource& source);

// By content, where `asked` says automatic.
Format format_of(ByteSource& source, Format asked);

// What the name of a file says; automatic where it says nothing.
Format format_called(std::string_view name);

}  // namespace winnow
