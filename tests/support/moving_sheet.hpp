// A sheet that waves: the frames of a sequence, as text and as arrays.
#pragma once

#include "base/vector.hpp"
#include "support/files.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace winnow::test {

// The unit square in 2 n^2 faces; the phase of its waves grows from frame to frame.
struct MovingSheet {
  std::size_t n = 20;

  [[nodiscard]] std::vector<Point> positions(std::size_t frame) const {
    const double phase = 0.4 * static_cast<double>(frame);
    std::vector<Point> out;
    for (std::size_t row = 0; row <= n; ++row) {
      for (std::size_t column = 0; column <= n; ++column) {
        const double x = static_cast<double>(column) / static_cast<double>(n);
        const double y = static_cast<double>(row) / static_cast<double>(n);
        const double bump = std::exp(-40 * ((x - 0.3) * (x - 0.3) + (y - 0.6) * (y - 0.6)));
        out.push_back({x, y, 0.05 * std::sin(5 * x + phase) + 0.1 * bump * std::sin(3 * phase)});
      }
    }
    return out;
  }
  [[nodiscard]] std::vector<std::array<std::uint32_t, 3>> faces() const {
    std::vector<std::array<std::uint32_t, 3>> out;
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t column = 0; column < n; ++column) {
        const auto a = static_cast<std::uint32_t>(row * (n + 1) + column);
        const auto up = a + static_cast<std::uint32_t>(n) + 1;
        out.push_back({a, a + 1, up + 1});
        out.push_back({a, up + 1, up});
      }
    }
    return out;
  }
};

inline std::string obj_of(const std::vector<Point>& positions,
                          const std::vector<std::array<std::uint32_t, 3>>& faces) {
  std::string text;
  for (const Point& p : positions) {
    text += "v";
    for (const double x : p) text += " " + std::to_string(x);
    text += "\n";
  }
  for (const auto& [a, b, c] : faces)
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " +
            std::to_string(c + 1) + "\n";
  return text;
}

// frame-0.obj, frame-1.obj and so on; returns their names.
inline std::vector<std::string> write_frames(const Directory& directory, const MovingSheet& sheet,
                                             std::size_t frames) {
  std::vector<std::string> names;
  for (std::size_t t = 0; t < frames; ++t) {
    names.push_back(directory.file("frame-" + std::to_string(t) + ".obj"));
    write_file(names.back(), obj_of(sheet.positions(t), sheet.faces()));
  }
  return names;
}

}  // namespace winnow::test
