// Vertices and faces as the bytes of a file format.
#pragma once

#include <winnow/simplify.hpp>

#include "base/attribute.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// What a header has to say before the first vertex.
struct MeshShape {
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  bool normals = false;                 // vertices carry normals
  bool double_positions = false;        // else float
  std::string comment;                  // one line; may be empty
  std::vector<Attribute> attributes{};  // that vertices carry
};

struct MeshVertex {
  std::array<double, 3> position{};
  std::array<float, 3> normal{};
  std::span<const double> attributes{};  // as many as the shape says; to be rounded to their types
};

struct MeshFace {
  std::array<std::uint64_t, 3> vertex{};
};

using Corners = std::array<std::array<double, 3>, 3>;

// Pure: the same calls give the same bytes, from any thread. A file is header(), all vertices, all faces.
class MeshEncoder {
 public:
  virtual ~MeshEncoder() = default;

  // Throws Error(usage) where the format cannot hold so much.
  [[nodiscard]] virtual std::string header(const MeshShape& shape) const = 0;

  // Append to `out`. A format that has no vertices of its own writes none.
  virtual void vertices(const MeshShape& shape, std::span<const MeshVertex> vertices,
                        std::vector<std::byte>& out) const = 0;

  // `corners` holds the positions of the faces' corners, or nothing where needs_corners() is false.
  virtual void faces(const MeshShape& shape, std::span<const MeshFace> faces,
                     std::span<const Corners> corners, std::vector<std::byte>& out) const = 0;

  [[nodiscard]] virtual bool needs_corners() const = 0;

  // Why the format cannot hold an attribute, in words that its name follows; empty where it can.
  [[nodiscard]] virtual std::string attribute_refusal(const Attribute& /*attribute*/) const {
    return "the output's format holds no attributes:";
  }
};

// The encoder for `format`; with Format::automatic for what the name ends in, PLY where that says nothing.
std::unique_ptr<MeshEncoder> make_encoder(Format format, const std::string& path);

// One function a format; a new one is a new file and a line in make_encoder.
std::unique_ptr<MeshEncoder> make_ply_encoder();
std::unique_ptr<MeshEncoder> make_stl_encoder();

}  // namespace winnow
