#include "read/indexed/locality.hpp"

#include "read/face_batch.hpp"

#include <algorithm>
#include <set>

namespace winnow {

void Locality::add_stretch(std::span<const std::uint32_t> numbers) {
  constexpr std::uint64_t page = 4096;
  constexpr std::size_t slice = 3 * FaceBatch::capacity;
  // What the first half brings into memory, the second may find there, as it would in the middle of
  // a pass.
  const std::size_t counted_from = numbers.size() / 2 / slice * slice;
  std::set<std::uint64_t> resident;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    const auto [low, high] = std::minmax({numbers[i], numbers[i + 1], numbers[i + 2]});
    ++seen_;
    far_ += high - low > near_;
  }
  for (std::size_t from = 0; from < numbers.size(); from += slice) {
    const auto corners = numbers.subspan(from, std::min(slice, numbers.size() - from));
    VertexRange range{UINT32_MAX, 0};
    for (const std::uint32_t number : corners) {
      const std::uint32_t vertex = number < vertices_.size() ? number : 0;
      range = {std::min(range.lowest, vertex), std::max(range.highest, vertex)};
    }
    std::uint64_t bytes = 0;
    if (vertices_.too_wide(range)) {
      bytes = corners.size() * page;
    } else {
      constexpr std::uint64_t block = VertexStore::resident_block;
      const std::uint64_t stride = vertices_.layout().stride;
      const std::uint64_t last = (range.highest + std::uint64_t{1}) * stride / block;
      for (std::uint64_t at = range.lowest * stride / block; at <= last; ++at)
        bytes += resident.insert(at).second ? block : 0;
    }
    if (from < counted_from) continue;
    bytes_ += bytes;
    faces_ += corners.size() / 3;
  }
}

double Locality::lookup_bytes(std::uint64_t faces) const {
  return faces_ == 0 ? 0
                     : static_cast<double>(bytes_) / static_cast<double>(faces_) *
                           static_cast<double>(faces);
}

}  // namespace winnow
