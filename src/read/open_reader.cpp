// Which format it is, and whether it has to be copied first.
#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/foreign_formats.hpp"
#include "read/formats.hpp"
#include "read/text/mesh.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace winnow {

namespace {

// Formats that are taken in whole when they are opened.
struct BufferedFormat {
  Format format;
  const char* name;
  TextMatch (*match)(std::string_view head);
  std::unique_ptr<MeshReader> (*open)(Job& job, std::unique_ptr<ByteSource> source,
                                      const ReaderMemory& memory, const AttributeRequest& wish);
  // By the first bytes; none: it offers nothing.
  AvailableAttributes (*offer)(Job& job, ByteSource& source) = nullptr;
};
constexpr std::array<BufferedFormat, 4> buffered_formats{
    {{Format::gltf, "glTF", match_gltf, open_gltf, offer_of_gltf},
     {Format::off, "OFF", match_off, open_off, offer_by_head<offer_of_off>},
     {Format::m, "M", match_m, open_m},
     {Format::obj, "OBJ", match_obj, open_obj, offer_by_head<offer_of_obj>}}};

const BufferedFormat* buffered_format(Format format) {
  const auto* found = std::find_if(buffered_formats.begin(), buffered_formats.end(),
                                   [&](const BufferedFormat& one) { return one.format == format; });
  return found == buffered_formats.end() ? nullptr : found;
}

std::string_view text_of(const Block& block) {
  return {reinterpret_cast<const char*>(block.bytes.data()), block.bytes.size()};
}

// The best match; of several the one that the file is called by, else the first.
Format format_of_text(std::string_view head, Format called) {
  Format best = Format::stl;  // whose reader refuses what is none
  TextMatch best_match = TextMatch::none;
  const auto consider = [&](Format format, TextMatch match) {
    if (match < best_match || match == TextMatch::none) return;
    if (match == TextMatch::named && format != called) return;
    if (match == best_match && format != called) return;
    best = format;
    best_match = match;
  };
  for (const BufferedFormat& format : buffered_formats) consider(format.format, format.match(head));
  consider(Format::stl, match_stl(head));
  return best;
}

// By content, where `asked` says automatic.
Format format_of(ByteSource& source, Format asked) {
  const bool fits_stl = has_size_of_binary_stl(source);  // whose header may hold anything
  if (!fits_stl) refuse_foreign(source);
  if (asked != Format::automatic) return asked;
  const Block block = source.peek(1024);
  const std::string_view head = without_byte_order_mark(text_of(block));
  if (head.starts_with("glTF")) return Format::gltf;
  if (match_ply(head)) return Format::ply;
  if (head.substr(0, 16).find("OFF BINARY") != std::string_view::npos) return Format::off;
  if (!is_text(head) || fits_stl) return Format::stl;
  // Comments may come first, a licence say.
  const Block more = source.peek(text_head_bytes);
  return format_of_text(without_byte_order_mark(text_of(more)), format_called(source.name()));
}

bool is_asked_for(Format format, Format asked, const ByteSource& source) {
  return asked == format || format_called(source.name()) == format;
}

// A PLY keeps its vertices anyway; only its faces cannot be had twice from a pipe. STL is all
// faces. Of a glTF the parts may be needed in any order.
bool needs_copy(const ByteSource& source, Format format, Access access) {
  if (format == Format::gltf) return !source.seekable();
  if (source.seekable() || access == Access::once || buffered_format(format) != nullptr)
    return false;
  return format == Format::stl || access == Access::repeatedly;
}

}  // namespace

Format format_called(std::string_view name) {
  std::string small(name);
  std::transform(small.begin(), small.end(), small.begin(), ascii_to_lower);
  std::string_view left = small;
  for (const std::string_view compression : {".gz", ".zst"}) {
    if (left.ends_with(compression)) left.remove_suffix(compression.size());
  }
  constexpr std::array<std::pair<std::string_view, Format>, 7> endings{{{".ply", Format::ply},
                                                                        {".stl", Format::stl},
                                                                        {".obj", Format::obj},
                                                                        {".off", Format::off},
                                                                        {".m", Format::m},
                                                                        {".glb", Format::gltf},
                                                                        {".gltf", Format::gltf}}};
  for (const auto& [ending, format] : endings) {
    if (left.ends_with(ending)) return format;
  }
  return Format::automatic;
}

std::unique_ptr<MeshReader> open_reader(Job& job, std::unique_ptr<ByteSource> source, Format from,
                                        Access access, const ReaderMemory& memory,
                                        const AttributeRequest& wish) {
  const Format format = format_of(*source, from);
  if (needs_copy(*source, format, access)) source = copy_to_scratch(job, std::move(source));
  if (format == Format::ply) return open_ply(job, std::move(source), memory, wish);
  if (const BufferedFormat* kept = buffered_format(format))
    return kept->open(job, std::move(source), memory, wish);
  choose_attributes(wish, {}, source->name());  // for its checks: there are none
  const bool asked = is_asked_for(Format::stl, from, *source);
  return open_stl(job, std::move(source), memory, asked);
}

InputProbe probe_input(Job& job, ByteSource& source, Format from, Access access,
                       const AttributeRequest& wish) {
  const Format format = format_of(source, from);
  InputProbe probe;
  if (format == Format::ply) {
    probe = probe_ply(source, wish);
  } else if (const BufferedFormat* kept = buffered_format(format)) {
    probe.facts.format = kept->name;
    if (kept->offer != nullptr) probe.facts.offer = kept->offer(job, source);
    probe.taken_in = true;
  } else {
    probe = probe_stl(source, is_asked_for(Format::stl, from, source));
  }
  if (format != Format::ply)
    probe.facts.choice = choose_attributes(wish, probe.facts.offer, source.name());
  probe.bytes = source.size();
  probe.copied_first = needs_copy(source, format, access);
  probe.compression = source.compression();
  if (format == Format::ply && source.map_name().empty() && !probe.copied_first)
    probe.vertices_buffered = true;
  return probe;
}

}  // namespace winnow
