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
  // `state`: `state_size` bytes of each vertex, which begin with what save() gave.
  Frames(const TileMesh& mesh, std::span<const std::byte> state, std::size_t state_size,
         std::size_t frames);

  // Bytes of a vertex: its positions in the frames from 1 on.
  static constexpr std::size_t saved_size(std::size_t frames) {
    return (frames - 1) * sizeof(Point);
  }
  static constexpr std::uint64_t memory(std::size_t frames, std::uint64_t vertices) {
    return vertices * frames * sizeof(Point);
  }

  [[nodiscard]] std::size_t count() const { return frames_; }
  [[nodiscard]] VertexPlaces places(std::size_t frame) const {
    return {position_.data() + frame, frames_};
  }
  // Of one vertex, a point for each frame.
  [[nodiscard]] std::span<const Point> positions(VertexNumber v) const {
    return std::span(position_).subspan(v * frames_, frames_);
  }
  [[nodiscard]] const std::vector<Point>& all_positions() const { return position_; }
  void move(VertexNumber v, std::span<const Point> to) {
    std::copy(to.begin(), to.end(), position_.begin() + static_cast<std::ptrdiff_t>(v * frames_));
  }

  // Writes saved_size() bytes.
  void save(VertexNumber v, std::byte* into) const;

 private:
  std::size_t frames_;
  std::vector<Point> position_;  // those of a vertex side by side
};

}  // namespace winnow
