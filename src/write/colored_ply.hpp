// A mesh in memory as a PLY with a colour and a number at each vertex.
#pragma once

#include "base/vector.hpp"
#include "io/byte_sink.hpp"
#include "io/job.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace winnow {

// Distances by their squares. Each vertex carries its distance as `quality`, which MeshLab and
// others show, and as its colour, the last of which is last_color_at() their root mean square.
void write_colored_ply(Job& job, std::span<const Point> vertices,
                       std::span<const std::array<std::uint32_t, 3>> faces,
                       std::span<const double> squared_distances, double diagonal, ByteSink& sink);

}  // namespace winnow
