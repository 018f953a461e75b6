// Which format it is, and whether it has to be copied first.
#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/foreign_formats.hpp"
#include "read/formats.hpp"
#include "read/text/lines.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace winnow {

namespace {

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
  for (const auto& [format, input] : input_formats) {
    if (input->match != nullptr) consider(format, input->match(head));
  }
  return best;
}

}  // namespace

Format format_of(ByteSource& source, Format asked) {
  const bool fits_stl = has_size_of_binary_stl(source);  // whose header may hold anything
  if (!fits_stl) refuse_foreign(source);
  if (asked != Format::automatic) return asked;
  const Block block = source.peek(1024);
  const std::string_view head = without_byte_order_mark(text_of(block));
  for (const auto& [format, input] : input_formats) {
    if (input->certain != nullptr && input->certain(head)) return format;
  }
  if (!is_text(head) || fits_stl) return Format::stl;
  // Comments may come first, a licence say.
  const Block more = source.peek(text_head_bytes);
  return format_of_text(without_byte_order_mark(text_of(more)), format_called(source.name()));
}

namespace {

bool is_asked_for(Format format, Format asked, const ByteSource& source) {
  return asked == format || format_called(source.name()) == format;
}

bool needs_copy(const ByteSource& source, const InputFormat& format, Access access) {
  if (source.seekable()) return false;
  switch (format.reading) {
    case Reading::faces:
      return access != Access::once;
    case Reading::vertices:
      return access == Access::repeatedly;
    case Reading::whole:
      return false;
    case Reading::whole_by_parts:
      break;
  }
  return true;
}

}  // namespace

Format format_called(std::string_view name) {
  std::string small(name);
  std::transform(small.begin(), small.end(), small.begin(), ascii_to_lower);
  std::string_view left = small;
  for (const std::string_view compression : {".gz", ".zst"}) {
    if (left.ends_with(compression)) left.remove_suffix(compression.size());
  }
  for (const Format format : all_values<Format>()) {
    for (const char* ending : facts_of(format).endings) {
      if (ending != nullptr && left.ends_with(std::string(".") + ending)) return format;
    }
  }
  return Format::automatic;
}

std::unique_ptr<MeshReader> open_reader(Job& job, std::unique_ptr<ByteSource> source, Format from,
                                        Access access, const ReaderMemory& memory,
                                        const AttributeRequest& wish) {
  const Format format = format_of(*source, from);
  const InputFormat& input = *input_format(format);
  if (needs_copy(*source, input, access)) source = copy_to_scratch(job, std::move(source));
  const bool asked = is_asked_for(format, from, *source);
  return input.open(job, std::move(source), memory, wish, asked);
}

InputProbe probe_input(Job& job, ByteSource& source, Format from, Access access,
                       const AttributeRequest& wish) {
  const Format format = format_of(source, from);
  const InputFormat& input = *input_format(format);
  InputProbe probe;
  probe.facts.format = facts_of(format).name;
  if (input.probe != nullptr) input.probe(job, source, is_asked_for(format, from, source), probe);
  probe.facts.choice = choose_attributes(wish, probe.facts.offer, source.name());
  probe.taken_in = input.reading == Reading::whole || input.reading == Reading::whole_by_parts;
  probe.bytes = source.size();
  probe.copied_first = needs_copy(source, input, access);
  probe.compression = source.compression();
  if (input.reading == Reading::vertices && source.map_name().empty() && !probe.copied_first)
    probe.vertices_buffered = true;
  return probe;
}

}  // namespace winnow
