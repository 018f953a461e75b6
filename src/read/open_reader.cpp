// Which format it is, and whether it has to be copied first.
#include <winnow/error.hpp>

#include "read/formats.hpp"

#include <cstring>

namespace winnow {

namespace {

Format format_of(ByteSource& source, Format asked) {
  if (asked != Format::automatic) return asked;
  const Block head = source.peek(4);
  const bool ply = head.bytes.size() == 4 && std::memcmp(head.bytes.data(), "ply", 3) == 0 &&
                   (head.bytes[3] == std::byte{'\n'} || head.bytes[3] == std::byte{'\r'});
  return ply ? Format::ply : Format::stl;
}

// A PLY keeps its vertices anyway; only its faces cannot be had twice from a pipe. STL is all faces.
bool needs_copy(const ByteSource& source, Format format, Access access) {
  if (source.seekable() || access == Access::once) return false;
  return format == Format::stl || access == Access::repeatedly;
}

}  // namespace

std::unique_ptr<MeshReader> open_reader(Job& job, std::unique_ptr<ByteSource> source, Format format,
                                        Access access, const ReaderMemory& memory,
                                        const AttributeWish& wish) {
  format = format_of(*source, format);
  if (needs_copy(*source, format, access)) source = copy_to_scratch(job, std::move(source));
  if (format == Format::ply) return open_ply(job, std::move(source), memory, wish);
  choose_attributes(wish, {}, source->name());  // for its checks: there are none
  return open_stl(job, std::move(source), memory);
}

InputOutlook look_at(Job& /*job*/, ByteSource& source, Format format, Access access,
                     const AttributeWish& wish) {
  format = format_of(source, format);
  if (format != Format::ply) choose_attributes(wish, {}, source.name());
  InputOutlook outlook = format == Format::ply ? look_at_ply(source, wish) : look_at_stl(source);
  outlook.bytes = source.size();
  outlook.copied_first = needs_copy(source, format, access);
  outlook.compression = source.compression();
  if (format == Format::ply && source.map_name().empty() && !outlook.copied_first)
    outlook.vertices_kept = true;
  return outlook;
}

}  // namespace winnow
