#include "read/gltf/file.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/ply/scalar.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace winnow {

namespace {

constexpr std::size_t head_bytes = 20;  // of a GLB, up to its JSON
constexpr std::uint32_t magic = 0x46546C67;
constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t binary_chunk = 0x004E4942;

[[noreturn]] void fail(const ByteSource& source, const std::string& what) {
  throw Error(ErrorKind::bad_input, "'" + source.name() + "' " + what);
}

std::uint32_t word(const Block& block, std::size_t at) {
  return load<std::uint32_t>(block.bytes.data() + at, false);
}

// Where the JSON ends; of a text that nobody knows the length of, UINT64_MAX.
std::uint64_t json_end_of(const ByteSource& source, const Block& head) {
  if (head.bytes.size() < 4 || word(head, 0) != magic) return source.size().value_or(UINT64_MAX);
  if (head.bytes.size() < head_bytes) fail(source, "ends inside its GLB header: it was cut short");
  if (word(head, 4) != 2)
    fail(source, "is GLB of version " + grouped(word(head, 4)) + "; version 2 is read");
  const std::uint64_t size = source.size().value_or(UINT64_MAX);
  if (word(head, 8) > size) {
    fail(source, "should have " + grouped(word(head, 8)) + " bytes by its GLB header, but has " +
                     grouped(size) + ": it was cut short");
  }
  if (word(head, 16) != json_chunk || word(head, 12) > size - head_bytes)
    fail(source, "does not begin with its JSON");
  return head_bytes + std::uint64_t{word(head, 12)};
}

// The first bytes up to `end`, or as many as there are. A pipe may promise what never comes, so
// that it is asked for more and more.
Block peek_up_to(ByteSource& source, std::uint64_t end, Budget& budget, Reservation& memory) {
  constexpr std::uint64_t at_first = std::uint64_t{1} << 16;
  for (std::uint64_t asked = source.size() ? end : std::min(at_first, end);;
       asked = std::min(2 * asked, end)) {
    // While it grows, the source may hold half of it twice.
    memory.release();
    memory = budget.reserve(asked + (source.size() ? 0 : asked / 2), "the JSON of a glTF");
    Block block = source.peek(asked);
    if (block.bytes.size() < asked || asked == end) return block;
  }
}

}  // namespace

GltfFile peek_gltf(Job& job, ByteSource& source) {
  const Block head = source.peek(head_bytes);
  GltfFile file;
  file.json_end = json_end_of(source, head);
  file.binary = head.bytes.size() == head_bytes && word(head, 0) == magic;
  Reservation text_memory;
  const Block block = peek_up_to(source, file.json_end, job.budget, text_memory);
  if (file.binary && block.bytes.size() < file.json_end)
    fail(source, "ends inside its JSON: it was cut short");
  const std::size_t begin = file.binary ? head_bytes : 0;
  const std::string_view json(reinterpret_cast<const char*>(block.bytes.data()) + begin,
                              block.bytes.size() - begin);
  file.memory = job.budget.reserve(memory_to_parse_gltf(json), "the JSON of a glTF");
  file.document = parse_gltf(json, source.name());
  block.check_intact(source.name());
  if (source.seekable()) source.seek(source.position());  // lets go of the JSON
  return file;
}

GltfOwnBuffer own_buffer_of(ByteSource& source, const GltfFile& file) {
  const std::uint64_t size = source.size().value_or(0);
  const std::uint64_t behind = (file.json_end + 3) / 4 * 4;
  if (!file.binary || behind > size || size - behind < 8) return {};
  source.seek(behind);
  const Block next = source.take(8);
  if (next.bytes.size() < 8 || word(next, 4) != binary_chunk) return {};
  if (word(next, 0) > size - behind - 8) fail(source, "ends inside its buffer: it was cut short");
  return {behind + 8, word(next, 0)};
}

}  // namespace winnow
