// Surfaces that are computed, never stored: any vertex and any face follows from its number alone,
// so a surface of any size can be streamed, in any order and by any number of threads.
#pragma once

#include "base/vector.hpp"
#include "generate/generate.hpp"
#include "write/mesh_encoder.hpp"

#include <cstdint>
#include <memory>
#include <span>

namespace winnow {

// Safe to use from all threads at once. Results are the same on every machine: nothing but +
// - * /, square root and conversions, which all are rounded exactly, ever touches a position.
class GeneratedSurface {
 public:
  virtual ~GeneratedSurface() = default;

  [[nodiscard]] virtual std::uint64_t vertices() const = 0;
  [[nodiscard]] virtual std::uint64_t faces() const = 0;

  // points[k] is vertex ids[k]. Any order is right; neighbours side by side are cheaper.
  virtual void positions(std::span<const std::uint64_t> ids, std::span<Point> points) const = 0;

  // corners[k] are the vertices of face ids[k], counter-clockwise seen from outside (from above).
  virtual void corners(std::span<const std::uint64_t> ids, std::span<MeshFace> corners) const = 0;

  [[nodiscard]] Point vertex(std::uint64_t id) const;
  [[nodiscard]] MeshFace face(std::uint64_t id) const;
};

// The surface that the options ask for; offset, shuffle and format are not its business. Throws
// Error(usage) where the count makes no sense.
std::unique_ptr<GeneratedSurface> make_surface(const GenerateOptions& options);

// One function a surface; a new one is a new file and a line in make_surface.
std::unique_ptr<GeneratedSurface> make_scan(const GenerateOptions& options);
std::unique_ptr<GeneratedSurface> make_terrain(const GenerateOptions& options);
std::unique_ptr<GeneratedSurface> make_part(const GenerateOptions& options);

}  // namespace winnow
