// Which format it is, and whether it has to be copied first.
#include <winnow/error.hpp>

#include "read/formats.hpp"
#include "read/text_mesh.hpp"
#include "read/text_tokens.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace winnow {

namespace {

// Formats that are taken in whole when they are opened.
struct KeptFormat {
  Format format;
  const char* name;
  bool (*is)(std::string_view head);
  std::unique_ptr<MeshReader> (*open)(Job& job, std::unique_ptr<ByteSource> source,
                                      const ReaderMemory& memory, const AttributeWish& wish);
  // By the first bytes; none: it offers nothing.
  AttributeOffer (*offer)(Job& job, ByteSource& source) = nullptr;
};
constexpr std::array<KeptFormat, 4> kept_formats{
    {{Format::gltf, "glTF", is_gltf, open_gltf, offer_of_gltf},
     {Format::off, "OFF", is_off, open_off, offer_by_head<offer_of_off>},
     {Format::m, "M", is_m, open_m},
     {Format::obj, "OBJ", is_obj, open_obj, offer_by_head<offer_of_obj>}}};

const KeptFormat* kept_format(Format format) {
  const auto* found = std::find_if(kept_formats.begin(), kept_formats.end(),
                                   [&](const KeptFormat& one) { return one.format == format; });
  return found == kept_formats.end() ? nullptr : found;
}

std::string_view text_of(const Block& block) {
  return {reinterpret_cast<const char*>(block.bytes.data()), block.bytes.size()};
}

Format format_of(ByteSource& source, Format asked) {
  if (asked != Format::automatic) return asked;
  const Block head = source.peek(1024);
  const std::string_view text = text_of(head);
  if (text.starts_with("glTF")) return Format::gltf;
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return Format::ply;
  if (text.substr(0, 16).find("OFF BINARY") != std::string_view::npos) return Format::off;
  if (!is_text(text)) return Format::stl;
  // Comments may come first, a licence say.
  const Block more = source.peek(text_head_bytes);
  for (const KeptFormat& format : kept_formats) {
    if (format.is(text_of(more))) return format.format;
  }
  return Format::stl;
}

// A PLY keeps its vertices anyway; only its faces cannot be had twice from a pipe. STL is all faces. Of a
// glTF the parts may be needed in any order.
bool needs_copy(const ByteSource& source, Format format, Access access) {
  if (format == Format::gltf) return !source.seekable();
  if (source.seekable() || access == Access::once || kept_format(format) != nullptr) return false;
  return format == Format::stl || access == Access::repeatedly;
}

}  // namespace

std::unique_ptr<MeshReader> open_reader(Job& job, std::unique_ptr<ByteSource> source, Format format,
                                        Access access, const ReaderMemory& memory,
                                        const AttributeWish& wish) {
  format = format_of(*source, format);
  if (needs_copy(*source, format, access)) source = copy_to_scratch(job, std::move(source));
  if (format == Format::ply) return open_ply(job, std::move(source), memory, wish);
  if (const KeptFormat* kept = kept_format(format)) return kept->open(job, std::move(source), memory, wish);
  choose_attributes(wish, {}, source->name());  // for its checks: there are none
  return open_stl(job, std::move(source), memory);
}

InputOutlook look_at(Job& job, ByteSource& source, Format format, Access access, const AttributeWish& wish) {
  format = format_of(source, format);
  InputOutlook outlook;
  if (format == Format::ply) {
    outlook = look_at_ply(source, wish);
  } else if (const KeptFormat* kept = kept_format(format)) {
    outlook.facts.format = kept->name;
    if (kept->offer != nullptr) outlook.facts.offer = kept->offer(job, source);
    outlook.taken_in = true;
  } else {
    outlook = look_at_stl(source);
  }
  if (format != Format::ply)
    outlook.facts.choice = choose_attributes(wish, outlook.facts.offer, source.name());
  outlook.bytes = source.size();
  outlook.copied_first = needs_copy(source, format, access);
  outlook.compression = source.compression();
  if (format == Format::ply && source.map_name().empty() && !outlook.copied_first)
    outlook.vertices_kept = true;
  return outlook;
}

}  // namespace winnow
