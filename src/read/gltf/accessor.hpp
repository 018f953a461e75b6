// The elements of a glTF accessor, from the first to the last.
#pragma once

#include "read/gltf/bytes.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// What an accessor is read as.
enum class GltfUse : std::uint8_t {
  indices,
  positions,
  normals,
  colors,
  color_moves,  // that a morph target adds
  vectors,
  rotations,
  numbers,  // of animations
};

class GltfElements {
 public:
  // Throws Error(bad_input) where the accessor holds something else.
  GltfElements(GltfBytes& bytes, const GltfDocument& document, std::size_t accessor, GltfUse use,
               std::string name);

  // Of an element: 1, 3, of rotations 4, or of colours 3 or 4.
  [[nodiscard]] unsigned components() const { return accessor_.components; }

  // Components of the next elements, some thousands, as many of each accessor of one count;
  // normalized ones as numbers from -1 or 0 to 1. Empty at the end; valid until the next call.
  std::span<const double> next();

 private:
  [[noreturn]] void fail(const std::string& what) const;
  void check(GltfUse use) const;
  // What stands in one view: of which type, how many components, how far apart.
  struct Layout {
    GltfType type{};
    unsigned components = 0;
    bool normalized = false;
    std::uint64_t stride = 0;  // 0: close
  };
  void read(const GltfSlice& slice, Layout layout, std::uint64_t first, std::size_t count,
            std::vector<double>& out);
  void change();  // what the sparse arrays say about the elements in values_

  GltfBytes& bytes_;
  const GltfDocument& document_;
  const GltfAccessor& accessor_;
  bool normalized_;
  std::string name_;
  std::uint64_t next_ = 0;
  std::vector<double> values_;
  std::uint64_t changed_ = 0;  // sparse elements taken in so far
  std::uint64_t changes_from_ = 0;
  std::vector<double> change_indices_, change_values_;
};

}  // namespace winnow
