#include "progressive/file_header.hpp"

#include <winnow/error.hpp>
#include <winnow/values.hpp>

#include "base/number_type.hpp"
#include "progressive/split_codec.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>
#include <string>

#include <zlib.h>

namespace winnow {

namespace {

constexpr std::size_t fixed_bytes = 128;
constexpr std::size_t entry_bytes = 32;
constexpr std::size_t attribute_bytes = 32;  // and its name
constexpr std::size_t checksum_at = 16;
constexpr std::uint32_t most_header_bytes = std::uint32_t{1} << 28;
constexpr std::uint32_t most_name = 1024;

class Writer {
 public:
  void u32(std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) bytes_.push_back(static_cast<std::byte>(value >> 8 * i));
  }
  void f64(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    u32(static_cast<std::uint32_t>(bits));
    u32(static_cast<std::uint32_t>(bits >> 32));
  }
  void point(const Point& p) {
    for (const double x : p) f64(x);
  }
  void raw(std::span<const std::byte> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  void set_u32(std::size_t at, std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) bytes_[at + i] = static_cast<std::byte>(value >> 8 * i);
  }
  std::vector<std::byte>& bytes() { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  Reader(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::uint32_t u32() {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(next()) << 8 * i;
    return value;
  }
  double f64() {
    const std::uint64_t low = u32();
    return std::bit_cast<double>(low | std::uint64_t{u32()} << 32);
  }
  Point point() {
    const double x = f64(), y = f64();
    return {x, y, f64()};
  }
  std::string text(std::uint32_t size) {
    std::string text;
    for (std::uint32_t i = 0; i < size; ++i) text += std::to_integer<char>(next());
    return text;
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorKind::bad_input, "'" + name_ + "' is damaged: " + why);
  }

 private:
  std::byte next() {
    if (at_ == bytes_.size()) refuse("its header is too short for what it tells of");
    return bytes_[at_++];
  }

  std::span<const std::byte> bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

std::size_t padded(std::size_t bytes) {
  return (bytes + 3) / 4 * 4;
}

void put(Writer& out, const Attribute& attribute) {
  out.u32(static_cast<std::uint32_t>(attribute.type));
  out.u32(static_cast<std::uint32_t>(attribute.kind));
  out.u32(attribute.no_data ? 1 : 0);
  out.u32(static_cast<std::uint32_t>(attribute.name.size()));
  out.f64(attribute.full);
  out.f64(attribute.no_data.value_or(0));
  std::string name = attribute.name;
  name.resize(padded(name.size()), '\0');
  out.raw(std::as_bytes(std::span(name)));
}

Attribute take_attribute(Reader& in) {
  Attribute attribute;
  const std::uint32_t type = in.u32(), kind = in.u32(), lacks = in.u32(), size = in.u32();
  if (type > static_cast<std::uint32_t>(NumberType::float64) ||
      is_wide_integer(static_cast<NumberType>(type)) ||
      kind > static_cast<std::uint32_t>(AttributeKind::label) || lacks > 1 || size > most_name)
    in.refuse("an attribute is of no known type");
  attribute.type = static_cast<NumberType>(type);
  attribute.kind = static_cast<AttributeKind>(kind);
  attribute.full = in.f64();
  const double no_data = in.f64();
  if (lacks != 0) attribute.no_data = no_data;
  attribute.name = in.text(static_cast<std::uint32_t>(padded(size))).substr(0, size);
  if (attribute.kind == AttributeKind::normal && !names_normal(attribute))
    in.refuse("a normal has a name of something else");
  return attribute;
}

ChunkEntry take_entry(Reader& in) {
  ChunkEntry entry;
  entry.bytes = in.u32();
  entry.raw_bytes = in.u32();
  entry.splits = in.u32();
  entry.vertices = in.u32();
  entry.faces = in.u32();
  entry.checksum = in.u32();
  entry.error = in.f64();
  if (!(entry.error >= 0)) in.refuse("the error of a level is none");
  if (entry.raw_bytes > most_chunk_bytes || entry.splits > entry.raw_bytes)
    in.refuse("a chunk is larger than one can be");
  return entry;
}

std::vector<std::byte> take_bytes(Job& job, ByteSource& source, std::uint64_t bytes) {
  constexpr std::size_t at_once = std::size_t{1} << 20;
  std::vector<std::byte> all;
  while (all.size() < bytes) {
    job.progress.check_cancelled();
    const Block block =
        source.take(static_cast<std::size_t>(std::min<std::uint64_t>(at_once, bytes - all.size())));
    if (block.bytes.empty()) break;
    all.insert(all.end(), block.bytes.begin(), block.bytes.end());
    block.check_intact(source.name());
  }
  return all;
}

// What comes behind the magic and the version.
ProgressiveHeader take_header(Reader& in) {
  ProgressiveHeader header;
  const std::uint32_t type = in.u32();
  header.form.bits = in.u32();
  if (type > 1 || header.form.bits > 30) in.refuse("positions are of no known type");
  header.form.doubles = type == 1;
  header.form.origin = in.point();
  header.form.step = in.f64();
  header.box.low = in.point();
  header.box.high = in.point();
  header.box.empty = false;
  if (!finite(header.form.origin) || !std::isfinite(header.form.step) || !finite(header.box.low) ||
      !finite(header.box.high))
    in.refuse("its box is not finite");
  const std::uint32_t cost = in.u32();
  const std::uint32_t normals = in.u32();
  if (cost == 0 || cost > static_cast<std::uint32_t>(Refine::importance) || normals > 1)
    in.refuse("it was made by no known cost");
  header.cost = static_cast<Refine>(cost);
  header.normals = normals != 0;
  return header;
}

}  // namespace

std::uint32_t checksum_of(std::span<const std::byte> bytes) {
  return static_cast<std::uint32_t>(
      ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

ProgressiveHeader::Counts ProgressiveHeader::counts(std::size_t chunk_count) const {
  Counts counts{0, 0, bytes()};
  for (std::size_t i = 0; i < chunk_count; ++i) {
    counts.vertices += chunks[i].vertices;
    counts.faces += chunks[i].faces;
    counts.bytes += chunks[i].bytes;
  }
  return counts;
}

std::size_t ProgressiveHeader::chunks_for(std::uint64_t faces) const {
  std::size_t count = base_chunks;
  for (std::uint64_t there = base().faces; there < faces && count < chunks.size(); ++count)
    there += chunks[count].faces;
  return count;
}

double ProgressiveHeader::position_error() const {
  if (form.bits == 0) return 0;
  double rounding = 0;
  if (!form.doubles) {
    for (const Point& corner : {box.low, box.high})
      for (const double x : corner) rounding = std::max(rounding, std::abs(x) * 0x1p-24);
  }
  return (form.step / 2 + rounding) * std::sqrt(3.0);
}

double ProgressiveHeader::error_of(std::size_t chunk_count) const {
  return chunk_count < chunks.size() ? chunks[chunk_count].error : position_error();
}

std::size_t ProgressiveHeader::chunks_within(double error) const {
  std::size_t count = chunks.size();
  while (count > base_chunks && error_of(count - 1) <= error) --count;
  return count;
}

std::uint64_t ProgressiveHeader::bytes() const {
  std::uint64_t bytes = fixed_bytes + chunks.size() * entry_bytes;
  for (const Attribute& attribute : attributes)
    bytes += attribute_bytes + padded(attribute.name.size());
  return bytes;
}

std::vector<std::byte> encode_header(const ProgressiveHeader& header) {
  Writer out;
  out.raw(std::as_bytes(std::span(progressive_magic)));
  out.u32(progressive_version);
  out.u32(static_cast<std::uint32_t>(header.bytes()));
  out.u32(0);  // the checksum
  out.u32(header.form.doubles ? 1 : 0);
  out.u32(header.form.bits);
  out.point(header.form.origin);
  out.f64(header.form.step);
  out.point(header.box.low);
  out.point(header.box.high);
  out.u32(static_cast<std::uint32_t>(header.cost));
  out.u32(header.normals ? 1 : 0);
  out.u32(static_cast<std::uint32_t>(header.attributes.size()));
  out.u32(header.base_chunks);
  out.u32(static_cast<std::uint32_t>(header.chunks.size()));
  for (const Attribute& attribute : header.attributes) put(out, attribute);
  for (const ChunkEntry& entry : header.chunks) {
    for (const std::uint32_t word :
         {entry.bytes, entry.raw_bytes, entry.splits, entry.vertices, entry.faces, entry.checksum})
      out.u32(word);
    out.f64(entry.error);
  }
  out.set_u32(checksum_at, checksum_of(out.bytes()));
  return std::move(out.bytes());
}

bool begins_progressive(ByteSource& source) {
  const Block head = source.peek(progressive_magic.size());
  return std::equal(head.bytes.begin(), head.bytes.end(), progressive_magic.begin(),
                    progressive_magic.end(),
                    [](std::byte byte, std::uint8_t magic) { return byte == std::byte{magic}; });
}

ProgressiveHeader read_header(Job& job, ByteSource& source) {
  const std::string& name = source.name();
  std::vector<std::byte> bytes = take_bytes(job, source, fixed_bytes);
  const std::size_t shown = std::min(bytes.size(), progressive_magic.size());
  if (shown == 0 || std::memcmp(bytes.data(), progressive_magic.data(), shown) != 0)
    throw Error(ErrorKind::bad_input, "'" + name +
                                          "' is no progressive mesh; `progressive` makes one of a "
                                          "mesh");
  Reader in(bytes, name);
  if (bytes.size() < fixed_bytes)
    throw Error(ErrorKind::bad_input, "'" + name + "' is cut short: its header is not whole");
  in.text(progressive_magic.size());
  const std::uint32_t version = in.u32();
  if (version != progressive_version)
    throw Error(ErrorKind::bad_input, "'" + name + "' has version " + std::to_string(version) +
                                          " of the format, and this program reads version " +
                                          std::to_string(progressive_version));
  const std::uint32_t size = in.u32();
  if (size < fixed_bytes || size > most_header_bytes) in.refuse("its header cannot be so long");
  const Reservation reserved = job.budget.reserve(2 * std::uint64_t{size}, "a file's header");
  const std::vector<std::byte> rest = take_bytes(job, source, size - fixed_bytes);
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  if (bytes.size() < size)
    throw Error(ErrorKind::bad_input, "'" + name + "' is cut short: its header is not whole");
  Reader all(bytes, name);
  all.text(checksum_at);
  const std::uint32_t checksum = all.u32();
  std::fill_n(bytes.begin() + checksum_at, 4, std::byte{});
  if (checksum != checksum_of(bytes)) all.refuse("its header is not what was written");
  ProgressiveHeader header = take_header(all);
  const std::uint32_t attributes = all.u32();
  header.base_chunks = all.u32();
  const std::uint32_t chunks = all.u32();
  if (attributes > most_attributes) all.refuse("it has too many attributes");
  for (std::uint32_t i = 0; i < attributes; ++i) header.attributes.push_back(take_attribute(all));
  if (all.left() != entry_bytes * std::uint64_t{chunks} || header.base_chunks > chunks)
    all.refuse("its header does not have as many chunks as it says");
  for (std::uint32_t i = 0; i < chunks; ++i) {
    header.chunks.push_back(take_entry(all));
    if (i > 0 && header.chunks[i].error > header.chunks[i - 1].error)
      all.refuse("a finer level is farther off");
  }
  const ProgressiveHeader::Counts base = header.base();
  if (base.vertices == 0 || base.faces == 0) all.refuse("its coarsest mesh is empty");
  const ProgressiveHeader::Counts counts = header.all();
  if (counts.vertices > UINT32_MAX || counts.faces > UINT32_MAX / 3)
    all.refuse("it tells of more vertices or faces than there can be");
  return header;
}

}  // namespace winnow
