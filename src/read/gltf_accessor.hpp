// The elements of a glTF accessor, from the first to the last.
#pragma once

#include "read/gltf_bytes.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace winnow {

class GltfElements {
 public:
  // `components`: 3 for points, 1 for indices. Throws Error(bad_input) where the accessor holds something
  // else.
  GltfElements(GltfBytes& bytes, const GltfDocument& document, std::size_t accessor, unsigned components,
               std::string name);

  [[nodiscard]] std::uint64_t size() const { return accessor_.count; }

  // Components of the next elements, some thousands; normalized ones as numbers from -1 or 0 to 1. Empty at
  // the end; valid until the next call.
  std::span<const double> next();

 private:
  [[noreturn]] void fail(const std::string& what) const;
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
  unsigned components_;
  bool normalized_;
  std::string name_;
  std::uint64_t next_ = 0;
  std::vector<double> values_;
  std::uint64_t changed_ = 0;  // sparse elements taken in so far
  std::uint64_t changes_from_ = 0;
  std::vector<double> change_indices_, change_values_;
};

}  // namespace winnow
