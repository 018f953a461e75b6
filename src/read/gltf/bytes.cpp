#include "read/gltf/bytes.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "io/spooled_source.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include <meshoptimizer.h>

namespace winnow {

namespace {

// "%20" and the like; nothing where it names no file beside or below its own.
std::optional<std::filesystem::path> path_of(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned code = 0;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(uri.data() + i + 1, uri.data() + i + 3, code, 16).ptr ==
            uri.data() + i + 3) {
      text += static_cast<char>(code);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  const std::filesystem::path path(text);
  const bool leaves =
      std::any_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
  if (text.empty() || path.is_absolute() || leaves ||
      text.find_first_of(std::string("\\:\0", 3)) != std::string::npos)
    return {};
  return path;
}

}  // namespace

void GltfBytes::fail(const std::string& what) const {
  throw Error(ErrorKind::bad_input, "'" + source_.name() + "': " + what);
}

std::span<const std::byte> GltfBytes::read(std::size_t view, std::uint64_t offset,
                                           std::size_t bytes) {
  const GltfView& from = document_.views[view];
  if (offset > from.bytes || bytes > from.bytes - offset)
    fail("an accessor reaches behind the end of its 'bufferView'");
  if (from.packing) return read_content(unpacked(view, *from.packing), offset, bytes);
  return read_content(buffer(from.buffer), from.offset + offset, bytes);
}

std::span<const std::byte> GltfBytes::read_content(Content& content, std::uint64_t offset,
                                                   std::size_t bytes) {
  if (offset > content.bytes || bytes > content.bytes - offset) {
    fail("a buffer ends after " + grouped(content.bytes) +
         " bytes, before what it should hold; it was cut short");
  }
  content.part = part_;
  if (content.file == nullptr) return std::span(content.memory).subspan(offset, bytes);
  const std::uint64_t at = content.begin + offset;
  if (content.file->position() != at) content.file->seek(at);
  last_ = content.file->take(bytes);
  last_.check_intact(content.file->name());
  if (last_.bytes.size() < bytes) fail("it was shortened while it was read");
  return last_.bytes;
}

GltfBytes::Content& GltfBytes::buffer(std::size_t index) {
  const auto found = buffers_.find(index);
  if (found != buffers_.end()) return found->second;
  const GltfBuffer& buffer = document_.buffers[index];
  Content content;
  if (!buffer.uri) {
    if (index != 0 || own_bytes_ == 0) fail("buffer " + std::to_string(index) + " has no data");
    content.file = &source_;
    content.begin = own_begin_;
    content.bytes = own_bytes_;
  } else if (buffer.uri->starts_with("data:")) {
    decode_base64(*buffer.uri, content);
  } else {
    close_one_of_many();
    content.owned = open_beside(*buffer.uri);
    content.file = content.owned.get();
    content.bytes = content.file->size().value_or(0);
  }
  if (content.bytes < buffer.bytes) {
    fail("buffer " + std::to_string(index) + " should have " + grouped(buffer.bytes) +
         " bytes, but there are " + grouped(content.bytes) +
         "; it was cut short, or is another file's");
  }
  return buffers_.emplace(index, std::move(content)).first->second;
}

// Each open file holds descriptors, and a window of it.
void GltfBytes::close_one_of_many() {
  constexpr std::ptrdiff_t most_open = 8;
  const auto open = [](const auto& entry) { return entry.second.owned != nullptr; };
  if (std::count_if(buffers_.begin(), buffers_.end(), open) < most_open) return;
  auto oldest = buffers_.end();
  for (auto entry = buffers_.begin(); entry != buffers_.end(); ++entry) {
    if (open(*entry) && (oldest == buffers_.end() || entry->second.part < oldest->second.part))
      oldest = entry;
  }
  buffers_.erase(oldest);
}

std::unique_ptr<ByteSource> GltfBytes::open_beside(const std::string& uri) {
  const std::optional<std::filesystem::path> path = path_of(uri);
  if (!path)
    fail("its buffer '" + uri.substr(0, 100) + "' is no file beside or below it, and is not read");
  if (source_.name() == "standard input")
    fail("its buffer '" + uri.substr(0, 100) +
         "' is a file beside it, which standard input has not; name the file");
  const std::string name = (std::filesystem::path(source_.name()).parent_path() / *path).string();
  // A lone "-" would be standard input.
  std::unique_ptr<ByteSource> file = open_source(job_, name == "-" ? "./-" : name, Unpacking::none);
  if (const std::optional<FileVersion> version = file->version())
    job_.watched.add(file->name(), *version);
  return file->seekable() ? std::move(file) : copy_to_scratch(job_, std::move(file));
}

void GltfBytes::decode_base64(std::string_view text, Content& into) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || !text.substr(0, comma).ends_with(";base64"))
    fail("a buffer in the JSON is not base64");
  text.remove_prefix(comma + 1);
  while (text.ends_with('=')) text.remove_suffix(1);
  into.reserved = job_.budget.reserve(text.size() / 4 * 3 + 3, "a buffer of the JSON");
  into.memory.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  unsigned held = 0;
  for (const char c : text) {
    const unsigned value = c >= 'A' && c <= 'Z'   ? static_cast<unsigned>(c - 'A')
                           : c >= 'a' && c <= 'z' ? static_cast<unsigned>(c - 'a' + 26)
                           : c >= '0' && c <= '9' ? static_cast<unsigned>(c - '0' + 52)
                           : c == '+'             ? 62U
                           : c == '/'             ? 63U
                                                  : 64U;
    if (value == 64) fail("a buffer in the JSON is not base64");
    bits = bits << 6 | value;
    held += 6;
    if (held < 8) continue;
    held -= 8;
    into.memory.push_back(static_cast<std::byte>(bits >> held & 0xff));
  }
  into.bytes = into.memory.size();
}

// Views of a part are read in turn, so that unpacking them again each time would take for ever.
void GltfBytes::set_aside() {
  std::erase_if(unpacked_, [this](const auto& one) { return one.second.part != part_; });
  for (auto& [view, content] : unpacked_) {
    if (content.file != nullptr) continue;
    std::vector<std::unique_ptr<Spool>> spools;
    spools.push_back(std::make_unique<Spool>(job_, 0));
    spools.back()->append(content.memory);
    spools.back()->finish();
    content.owned = spooled_source(source_.name(), "", std::move(spools));
    content.file = content.owned.get();
    std::vector<std::byte>().swap(content.memory);
    content.reserved.release();
  }
}

GltfBytes::Content& GltfBytes::unpacked(std::size_t view, const GltfPacking& packing) {
  const auto found = unpacked_.find(view);
  if (found != unpacked_.end()) {
    found->second.part = part_;
    return found->second;
  }
  const std::uint64_t bytes = packing.count * packing.stride;
  Content content;
  content.part = part_;
  content.reserved = job_.budget.try_reserve(bytes + packing.bytes);
  if (!content.reserved) {
    set_aside();
    content.reserved = job_.budget.reserve(bytes + packing.bytes, "unpacking a part of the glTF");
  }
  const std::span<const std::byte> packed =
      read_content(buffer(packing.buffer), packing.offset, packing.bytes);
  content.memory.resize(bytes);
  content.bytes = bytes;
  const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
  int failed = 0;
  switch (packing.mode) {
    case GltfPacking::Mode::attributes:
      failed = meshopt_decodeVertexBuffer(content.memory.data(), packing.count, packing.stride,
                                          from, packed.size());
      break;
    case GltfPacking::Mode::triangles:
      failed = meshopt_decodeIndexBuffer(content.memory.data(), packing.count, packing.stride, from,
                                         packed.size());
      break;
    case GltfPacking::Mode::indices:
      failed = meshopt_decodeIndexSequence(content.memory.data(), packing.count, packing.stride,
                                           from, packed.size());
      break;
  }
  if (failed != 0) fail("a packed 'bufferView' is damaged, or packed in a way that is not known");
  if (packing.filter == GltfPacking::Filter::octahedral)
    meshopt_decodeFilterOct(content.memory.data(), packing.count, packing.stride);
  if (packing.filter == GltfPacking::Filter::exponential)
    meshopt_decodeFilterExp(content.memory.data(), packing.count, packing.stride);
  if (packing.filter == GltfPacking::Filter::other)
    fail("what vertices have is packed by a filter that is not for that; the file is damaged");
  return unpacked_.emplace(view, std::move(content)).first->second;
}

}  // namespace winnow
