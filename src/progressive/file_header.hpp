// The head of a progressive file: what is in it, and how long each chunk is.
#pragma once

#include <winnow/costs.hpp>

#include "base/attribute.hpp"
#include "base/box.hpp"
#include "io/byte_source.hpp"
#include "progressive/vertex_words.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// The byte of more than seven bits, and the two kinds of line ends, are hurt by what takes the file
// for text.
inline constexpr std::array<std::uint8_t, 8> progressive_magic{0x89, 'W',  'P',  'M',
                                                               '\r', '\n', 0x1a, '\n'};
inline constexpr std::uint32_t progressive_version = 2;

// What one chunk adds.
struct ChunkEntry {
  std::uint32_t bytes = 0;      // in the file
  std::uint32_t raw_bytes = 0;  // before they were compressed
  std::uint32_t splits = 0, vertices = 0, faces = 0;
  std::uint32_t checksum = 0;  // CRC-32 of the bytes in the file
  // Within which the mesh keeps the surface that all chunks before this one give: as
  // SimplifyOptions::error has it, infinite where none is known. Of base chunks that of the
  // coarsest mesh.
  double error = 0;
};

struct ProgressiveHeader {
  PositionForm form;
  Box box;  // of all vertices at full count
  Refine cost = Refine::quadric;
  bool normals = false;  // of the input
  std::vector<Attribute> attributes{};
  std::uint32_t base_chunks = 0;  // of them the coarsest mesh is made
  std::vector<ChunkEntry> chunks{};

  struct Counts {
    std::uint64_t vertices = 0, faces = 0, bytes = 0;
  };
  // With so many chunks; of bytes those of the header as well.
  [[nodiscard]] Counts counts(std::size_t chunk_count) const;
  [[nodiscard]] Counts base() const { return counts(base_chunks); }
  [[nodiscard]] Counts all() const { return counts(chunks.size()); }
  // The fewest chunks that have so many faces; all where none have.
  [[nodiscard]] std::size_t chunks_for(std::uint64_t faces) const;
  // By how much a lattice moves a position at most.
  [[nodiscard]] double position_error() const;
  // The least error that a count of chunks keeps, and the fewest that keep this one; all where none
  // do.
  [[nodiscard]] double error_of(std::size_t chunk_count) const;
  [[nodiscard]] std::size_t chunks_within(double error) const;
  [[nodiscard]] std::uint64_t bytes() const;  // of the header itself
};

std::vector<std::byte> encode_header(const ProgressiveHeader& header);

// Whether the content, of which nothing was taken yet, begins as a progressive file does.
bool begins_progressive(ByteSource& source);

// From the beginning of the content. Throws Error(bad_input) naming what is wrong.
ProgressiveHeader read_header(Job& job, ByteSource& source);

std::uint32_t checksum_of(std::span<const std::byte> bytes);

}  // namespace winnow
