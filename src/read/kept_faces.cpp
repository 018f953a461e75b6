#include "read/kept_faces.hpp"

#include <algorithm>

namespace winnow {

void KeptFaces::add_degenerate() {
  add(degenerate);
}

std::array<std::uint32_t, 3> KeptFaces::kept(const RawBatch& batch, std::size_t face) {
  if (batch.status[face] != FaceStatus::good) return degenerate;
  std::array<std::uint32_t, 3> indices{};
  std::copy_n(&batch.indices[3 * face], 3, indices.begin());
  if (indices == degenerate) indices.fill(UINT32_MAX);
  return indices;
}

void KeptFaces::add(const RawBatch& batch) {
  for (std::size_t i = 0; i < batch.count; ++i) add(kept(batch, i));
}

void KeptFaces::restore_status(RawBatch& batch) {
  batch.status.assign(batch.count, FaceStatus::good);
  for (std::size_t i = 0; i < batch.count; ++i) {
    const auto face = std::span(batch.indices).subspan(3 * i, 3);
    if (face[0] != UINT32_MAX || !std::equal(face.begin(), face.end(), degenerate.begin())) continue;
    std::fill(face.begin(), face.end(), 0);
    batch.status[i] = FaceStatus::degenerate;
  }
}

void KeptFaces::read(std::uint64_t first, std::size_t most, RawBatch& batch) const {
  batch.count = std::min<std::uint64_t>(most, size() - first);
  batch.indices.resize(3 * batch.count);
  spool_.read(first * bytes_a_face, std::as_writable_bytes(std::span(batch.indices)));
  restore_status(batch);
}

}  // namespace winnow
