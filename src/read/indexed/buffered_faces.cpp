#include "read/indexed/buffered_faces.hpp"

#include "base/search.hpp"
#include "io/spool_records.hpp"

#include <algorithm>

namespace winnow {

void BufferedFaces::add_degenerate() {
  add(degenerate);
}

std::array<std::uint32_t, 3> BufferedFaces::kept(const RawBatch& batch, std::size_t face) {
  if (batch.status[face] != FaceStatus::good) return degenerate;
  std::array<std::uint32_t, 3> indices{};
  std::copy_n(&batch.indices[3 * face], 3, indices.begin());
  if (indices == degenerate) indices.fill(UINT32_MAX);
  return indices;
}

void BufferedFaces::add_polygon(std::span<const std::uint32_t> corners) {
  if (corners.size() == 3) return add(corners);
  if (corners.size() < 3) return add_degenerate();
  add_fan(size(), corners.size() - 2);
  constexpr std::size_t most = 3 * 4096;
  fan_.clear();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    fan_.insert(fan_.end(), {corners[0], corners[i - 1], corners[i]});
    if (fan_.size() < most) continue;
    add(fan_);
    fan_.clear();
  }
  add(fan_);
}

void BufferedFaces::add(const RawBatch& batch) {
  for (const RawBatch::Fan& fan : batch.fans) add_fan(size() + fan.first, fan.triangles);
  for (std::size_t i = 0; i < batch.count; ++i) add(kept(batch, i));
}

void BufferedFaces::add_fan(std::uint64_t first, std::uint64_t triangles) {
  if (last_fans_.count > 0 && (last_fans_.triangles != triangles || last_fans_.end() != first)) {
    append_records<Fans>(fans_, std::span(&last_fans_, 1));
    last_fans_.count = 0;
  }
  if (last_fans_.count == 0) last_fans_ = {first, 0, triangles};
  ++last_fans_.count;
}

void BufferedFaces::finish() {
  if (last_fans_.count > 0) append_records<Fans>(fans_, std::span(&last_fans_, 1));
  fans_.finish();
  spool_.finish();
}

std::uint64_t BufferedFaces::fans_behind(std::uint64_t triangle) const {
  return first_not_before(0, record_count<Fans>(fans_), [&](std::uint64_t i) {
    return read_record<Fans>(fans_, i).end() <= triangle;
  });
}

std::uint64_t BufferedFaces::begin_of(std::uint64_t triangle) const {
  const std::uint64_t at = fans_behind(triangle);
  if (at == record_count<Fans>(fans_)) return triangle;
  const Fans fans = read_record<Fans>(fans_, at);
  return fans.first > triangle ? triangle : triangle - (triangle - fans.first) % fans.triangles;
}

void BufferedFaces::restore_status(RawBatch& batch, std::size_t from) {
  batch.status.resize(from);
  batch.status.resize(batch.indices.size() / 3, FaceStatus::good);
  for (std::size_t i = from; i < batch.status.size(); ++i) {
    const auto face = std::span(batch.indices).subspan(3 * i, 3);
    if (face[0] != UINT32_MAX || !std::equal(face.begin(), face.end(), degenerate.begin()))
      continue;
    std::fill(face.begin(), face.end(), 0);
    batch.status[i] = FaceStatus::degenerate;
  }
}

void BufferedFaces::read(std::uint64_t first, std::size_t most, RawBatch& batch,
                         const Grow& grow) const {
  batch.count = std::min<std::uint64_t>(most, size() - first);
  batch.fans.clear();
  for (std::uint64_t i = fans_behind(first); i < record_count<Fans>(fans_); ++i) {
    const Fans fans = read_record<Fans>(fans_, i);
    if (fans.first >= first + batch.count) break;
    for (std::uint64_t at = std::max(fans.first, first);
         at < std::min(fans.end(), first + batch.count); at += fans.triangles) {
      batch.fans.push_back({at - first, fans.triangles});
      batch.count = std::max(batch.count, at + fans.triangles - first);
    }
  }
  if (grow) grow(batch.count);
  batch.indices.reserve(3 * batch.count);
  batch.status.reserve(batch.count);
  batch.indices.clear();
  batch.status.clear();
  constexpr std::uint64_t at_once = 1 << 18;
  for (std::uint64_t from = 0; from < batch.count; from += at_once) {
    const std::uint64_t until = std::min(batch.count, from + at_once);
    batch.indices.resize(3 * until);
    spool_.read((first + from) * bytes_a_face,
                std::as_writable_bytes(std::span(batch.indices).subspan(3 * from)));
    restore_status(batch, from);
    if (grow) grow(until);
  }
}

}  // namespace winnow
