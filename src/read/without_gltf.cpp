// In the place of read/gltf in a library without that part.
#include <winnow/parts.hpp>

#include "io/byte_source.hpp"
#include "read/formats.hpp"
#include "read/morph_frames.hpp"

namespace winnow {

namespace {

[[noreturn]] void refuse(const ByteSource& source) {
  throw MissingPart(Part::gltf, "'" + source.name() + "' cannot be read");
}

}  // namespace

const InputFormat gltf_input{
    .reading = Reading::whole_by_parts,
    .open = [](Job& /*job*/, std::unique_ptr<ByteSource> source, const ReaderMemory& /*memory*/,
               const AttributeRequest& /*wish*/,
               bool /*asked*/) -> std::unique_ptr<MeshReader> { refuse(*source); },
    .probe = [](Job& /*job*/, ByteSource& source, bool /*asked*/,
                InputProbe& /*probe*/) { refuse(source); },
    .certain = [](std::string_view head) { return head.starts_with("glTF"); },
    .match = match_gltf};

std::unique_ptr<MorphFrames> open_morph_frames(Job& job, const std::string& name, Format from) {
  const std::unique_ptr<ByteSource> source = open_source(job, name);
  if (format_of(*source, from) != Format::gltf) return nullptr;
  refuse(*source);
}

}  // namespace winnow
