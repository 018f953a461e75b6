// Splits as bytes, and back. What most splits are, two faces that come back beside an anchor with a
// few faces, takes a byte each for its kind, the first face that moves and how many do.
//
// docs/progressive_format.md tells of every byte.
#pragma once

#include "progressive/look_ahead.hpp"
#include "progressive/ring.hpp"
#include "progressive/split.hpp"
#include "progressive/split_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

// A split, and what is around its anchor before it.
struct RingedSplit {
  Split split;
  Words before;                 // the anchor's words, where it moves
  std::uint32_t first_new = 0;  // the number of the first new vertex
  // All faces at the anchor, in the beginning those that move. Empty where these are very many, or
  // are not known: then the faces that move are told one by one.
  std::vector<FarEdge> ring{};

  // From the ring, which is known.
  void take_moved() { std::copy_n(ring.begin(), split.moved.size(), split.moved.begin()); }
};

// Of the bytes of a chunk, before they are compressed.
inline constexpr std::uint32_t most_chunk_bytes = std::uint32_t{1} << 26;

// Takes the splits of a chunk in order; numbers are those of the reader.
class SplitEncoder {
 public:
  explicit SplitEncoder(std::size_t width) : width_(width), values_(width) {}

  void add(const RingedSplit& ringed);
  // Everything that was added, compressed. Begins anew.
  std::vector<std::byte> finish(std::uint32_t& raw_bytes);

 private:
  bool add_beside(const RingedSplit& ringed);
  bool find_sides(const RingedSplit& ringed, std::uint32_t& left, std::uint32_t& right) const;
  bool find_walk(const RingedSplit& ringed, std::uint32_t left, std::uint32_t right);
  void gather_ring(const RingedSplit& ringed);
  [[nodiscard]] bool moves_those(const RingedSplit& ringed) const;
  bool add_bits(const RingedSplit& ringed);
  void add_one_by_one(const RingedSplit& ringed);
  void add_values(const RingedSplit& ringed);

  std::size_t width_;
  std::vector<std::uint8_t> kinds_, rings_, counts_, varints_;
  std::vector<std::uint32_t> anchors_;
  std::vector<Words> values_;  // of each word of a vertex
  Ring ring_;                  // of the anchor
  std::vector<std::uint32_t> neighbours_, places_;
  std::size_t first_place_ = 0;
};

// Throws Error(bad_input) where the bytes are not what an encoder makes.
class SplitDecoder {
 public:
  SplitDecoder(std::span<const std::byte> packed, std::uint32_t raw_bytes, std::uint32_t splits,
               std::size_t width);

  // The next split, of a mesh to which all before were applied.
  void next(const SplitMesh& mesh, Split& split);
  [[nodiscard]] std::uint32_t left() const { return splits_ - done_; }

 private:
  struct Bytes {
    const std::uint8_t* at = nullptr;
    const std::uint8_t* end = nullptr;
    std::uint8_t byte();
    std::uint32_t varint();
    [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end - at); }
  };
  Bytes section();
  void read_anchors(Bytes bytes);
  void read_words(std::size_t rows);
  void beside(const SplitMesh& mesh, unsigned kind, Split& split);
  void take_walk(Split& split);
  std::uint32_t take_neighbour();
  void take_bits(Split& split);
  void tell_one_by_one(const SplitMesh& mesh, bool moves, Split& split);
  void values(const SplitMesh& mesh, Split& split);

  std::vector<std::uint8_t> raw_;
  std::size_t width_;
  std::uint32_t splits_, done_ = 0;
  Bytes rest_, kinds_, rings_, counts_, varints_;
  std::vector<std::uint32_t> anchors_;
  std::size_t anchor_ = 0;
  LookAhead ahead_;
  Words differences_;    // of the words from what is likely, vertex by vertex
  std::size_t row_ = 0;  // the next of them
  Ring ring_;            // of the anchor
  std::vector<std::uint32_t> neighbours_, places_;
};

}  // namespace winnow
