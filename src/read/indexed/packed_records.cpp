#include "read/indexed/packed_records.hpp"

#include <algorithm>
#include <cstring>

namespace winnow {

PackedRecords::PackedRecords(const VertexLayout& whole)
    : whole_stride_(whole.stride), layout_(whole) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    pieces_.push_back({whole.offset[axis], size_of(whole.type[axis])});
  for (const VertexLayout::Number& number : whole.attributes)
    pieces_.push_back({number.offset, size_of(number.type)});
  std::sort(pieces_.begin(), pieces_.end(),
            [](const Piece& a, const Piece& b) { return a.from < b.from; });
  const auto packed_offset = [&](std::size_t offset) {
    std::size_t before = 0;
    for (const Piece& piece : pieces_) before += piece.from < offset ? piece.size : 0;
    return before;
  };
  for (std::size_t& offset : layout_.offset) offset = packed_offset(offset);
  for (VertexLayout::Number& number : layout_.attributes)
    number.offset = packed_offset(number.offset);
  layout_.stride = packed_offset(whole.stride);
  // Neighbours are copied at once.
  std::vector<Piece> joined;
  for (const Piece& piece : pieces_) {
    if (!joined.empty() && joined.back().from + joined.back().size == piece.from) {
      joined.back().size += piece.size;
    } else {
      joined.push_back(piece);
    }
  }
  pieces_ = std::move(joined);
}

void PackedRecords::pack(const std::byte* whole, std::size_t count, std::byte* packed) const {
  for (; count > 0; --count, whole += whole_stride_) {
    for (const Piece& piece : pieces_) {
      std::memcpy(packed, whole + piece.from, piece.size);
      packed += piece.size;
    }
  }
}

}  // namespace winnow
