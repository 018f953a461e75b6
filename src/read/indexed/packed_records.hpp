// Of vertices' records the bytes that are needed, side by side.
#pragma once

#include "read/indexed/vertex_store.hpp"

#include <cstddef>
#include <vector>

namespace winnow {

class PackedRecords {
 public:
  explicit PackedRecords(const VertexLayout& whole);

  [[nodiscard]] const VertexLayout& layout() const { return layout_; }  // of a packed record
  [[nodiscard]] std::size_t size() const { return layout_.stride; }

  // Nothing is left out: whole records are packed already.
  [[nodiscard]] bool same() const { return layout_.stride == whole_stride_; }

  void pack(const std::byte* whole, std::size_t count, std::byte* packed) const;

 private:
  struct Piece {
    std::size_t from, size;
  };
  std::size_t whole_stride_;
  std::vector<Piece> pieces_;  // in their order
  VertexLayout layout_;
};

}  // namespace winnow
