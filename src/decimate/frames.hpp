// The vertices of a tile in every frame of a sequence. Frame 0 is the mesh itself.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

class Frames {
 public:
  // `state`: what save() gave for each vertex; or, before the first collapse, the positions alone.
  Frames(const TileMesh& mesh, std::span<const std::byte> state, std::size_t frames,
         bool before_collapses);

  // Bytes of a vertex: its positions in the frames from 1 on, and behind them a witness point of
  // each frame (witness_points.hpp).
  static constexpr std::size_t first_state_size(std::size_t frames) {
    return (frames - 1) * sizeof(Point);
  }
  static constexpr std::size_t state_size(std::size_t frames) {
    return first_state_size(frames) + frames * sizeof(Point);
  }
  static constexpr std::uint64_t memory(std::size_t frames, std::uint64_t vertices) {
    return vertices * 2 * frames * sizeof(Point);
  }

  [[nodiscard]] std::size_t count() const { return frames_; }
  [[nodiscard]] VertexPlaces places(std::size_t frame) const {
    return {position_.data() + frame, frames_};
  }
  // Of one vertex, a point for each frame.
  [[nodiscard]] std::span<const Point> positions(VertexNumber v) const { return of(position_, v); }
  [[nodiscard]] std::span<const Point> witnesses(VertexNumber v) const { return of(witness_, v); }
  void move(VertexNumber v, std::span<const Point> to) { set(position_, v, to); }
  void set_witnesses(VertexNumber v, std::span<const Point> points) { set(witness_, v, points); }

  // Writes state_size() bytes.
  void save(VertexNumber v, std::byte* into) const;

 private:
  [[nodiscard]] std::span<const Point> of(const std::vector<Point>& points, VertexNumber v) const {
    return std::span(points).subspan(v * frames_, frames_);
  }
  void set(std::vector<Point>& points, VertexNumber v, std::span<const Point> to) const {
    std::copy(to.begin(), to.end(), points.begin() + static_cast<std::ptrdiff_t>(v * frames_));
  }

  std::size_t frames_;
  std::vector<Point> position_, witness_;  // those of a vertex side by side
};

}  // namespace winnow
