// A progressive file whose chunks are not compressed: they are, and get their checksums, before it
// is read. So what is changed reaches the decoder.
#include "fuzz/job.hpp"
#include "fuzz/targets.hpp"
#include "progressive/split_player.hpp"
#include "support/sources.hpp"

#include <memory>
#include <string>
#include <vector>

#include <zlib.h>

namespace winnow::fuzz {

namespace {

constexpr std::size_t fixed_bytes = 128;
constexpr std::size_t entry_bytes = 32;

std::uint32_t u32_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < 4; ++i)
    value |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << 8 * i;
  return value;
}

void set_u32(std::string& bytes, std::size_t at, std::uint32_t value) {
  for (unsigned i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> 8 * i);
}

std::uint32_t checksum(const std::string& bytes) {
  return checksum_of(std::as_bytes(std::span(bytes)));
}

std::string deflated(const std::string& raw) {
  z_stream stream{};
  expect(deflateInit2(&stream, 1, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) == Z_OK, "zlib begins");
  std::string out(deflateBound(&stream, static_cast<uLong>(raw.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(raw.data()));
  stream.avail_in = static_cast<uInt>(raw.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  expect(deflate(&stream, Z_FINISH) == Z_STREAM_END, "zlib ends");
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

// Where the header does not tell of chunks it stays as it is.
std::string packed(std::string file) {
  if (file.size() < fixed_bytes) return file;
  const std::size_t size = u32_at(file, 12);
  const std::size_t chunks = u32_at(file, 124);
  if (size > file.size() || size < fixed_bytes || chunks > (size - fixed_bytes) / entry_bytes)
    return file;
  std::string header = file.substr(0, size);
  std::string body;
  std::size_t at = size;
  for (std::size_t entry = size - chunks * entry_bytes; entry < size; entry += entry_bytes) {
    const std::string raw =
        at < file.size() ? file.substr(at, u32_at(header, entry + 4)) : std::string();
    at += raw.size();
    const std::string chunk = deflated(raw);
    set_u32(header, entry, static_cast<std::uint32_t>(chunk.size()));
    set_u32(header, entry + 4, static_cast<std::uint32_t>(raw.size()));
    set_u32(header, entry + 20, checksum(chunk));
    body += chunk;
  }
  set_u32(header, 16, 0);
  set_u32(header, 16, checksum(header));
  return header + body;
}

void check_mesh(const SplitMesh& mesh) {
  for (std::uint32_t f = 0; f < mesh.faces(); ++f) {
    const FaceVertices& face = mesh.face(f);
    for (const std::uint32_t v : face) expect(v < mesh.vertices(), "a face has vertices");
    expect(face[0] != face[1] && face[1] != face[2] && face[2] != face[0], "a face has corners");
  }
}

}  // namespace

void play(std::span<const std::byte> bytes) {
  const std::string file = packed({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  FuzzJob fuzz;
  survives([&] {
    SplitPlayer player(fuzz.job, std::make_unique<test::MemorySource>(file), true);
    check_mesh(player.mesh());
    const std::uint32_t faces = player.mesh().faces();
    const std::uint32_t vertices = player.mesh().vertices();
    std::uint64_t steps = 0;
    survives([&] {
      while (player.forward()) ++steps;
    });
    check_mesh(player.mesh());
    expect(player.mesh().faces() <= player.header().all().faces, "faces are told of");
    while (player.backward()) {
      expect(steps > 0, "no more steps lead back");
      --steps;
    }
    check_mesh(player.mesh());
    expect(steps == 0 && player.mesh().faces() == faces && player.mesh().vertices() == vertices,
           "the base is what it was");
  });
}

}  // namespace winnow::fuzz
