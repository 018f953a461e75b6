#include "progressive/deflate.hpp"

#include <winnow/error.hpp>

#include <zlib.h>

namespace winnow {

namespace {

// Bytes; a code takes some hundred bits.
constexpr std::size_t worth_a_code = 200;

[[noreturn]] void refuse_packed() {
  throw Error(ErrorKind::bad_input, "a chunk is damaged");
}

}  // namespace

std::vector<std::byte> deflated(std::span<const std::uint8_t> raw,
                                std::span<const std::size_t> ends) {
  z_stream stream{};
  // Numbers repeat, but no strings of them do: looking for these takes twice the time and makes
  // codes longer.
  if (deflateInit2(&stream, 6, Z_DEFLATED, -15, 9, Z_RLE) != Z_OK)
    throw Error(ErrorKind::resources, "there is no memory to compress with");
  std::vector<std::byte> out(deflateBound(&stream, static_cast<uLong>(raw.size())) +
                             16 * ends.size() + 16);
  stream.next_in = const_cast<Bytef*>(raw.data());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  std::size_t begin = 0;
  int result = Z_OK;
  for (const std::size_t end : ends) {
    if (end - begin < worth_a_code) continue;
    stream.avail_in = static_cast<uInt>(end - begin);
    begin = end;
    result = deflate(&stream, Z_BLOCK);
    if (result != Z_OK || stream.avail_in > 0) break;
  }
  stream.avail_in += static_cast<uInt>(raw.size() - begin);
  result = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw Error(ErrorKind::failed, "a chunk could not be compressed");
  return out;
}

std::vector<std::uint8_t> inflated(std::span<const std::byte> packed, std::uint32_t raw_bytes,
                                   std::uint32_t most) {
  // Deflate makes a thousandth at best, and a damaged size must not take memory.
  if (raw_bytes > most || raw_bytes / 1100 > packed.size()) refuse_packed();
  std::vector<std::uint8_t> raw(raw_bytes);
  z_stream stream{};
  if (inflateInit2(&stream, -15) != Z_OK)
    throw Error(ErrorKind::resources, "there is no memory to decompress with");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = raw.data();
  stream.avail_out = static_cast<uInt>(raw.size());
  const int result = inflate(&stream, Z_FINISH);
  const bool whole = result == Z_STREAM_END && stream.avail_out == 0 && stream.avail_in == 0;
  inflateEnd(&stream);
  if (!whole) refuse_packed();
  return raw;
}

}  // namespace winnow
