// Vertices and faces as the bytes of a file format.
#pragma once

#include <winnow/format.hpp>

#include "base/attribute.hpp"
#include "base/box.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace winnow {

// What a header has to say before the first vertex.
struct MeshShape {
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  bool normals = false;                 // vertices carry normals
  bool double_positions = false;        // else every position is a float
  std::string comment{};                // one line; may be empty
  Box box{};                            // of all vertices; only where needs_survey() asks for it
  std::vector<Attribute> attributes{};  // that vertices carry
  bool closed = false;     // each edge has a face on either side; where needs_survey() asks
  bool as_stored = false;  // these are the numbers of the input, not means of them
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

// A part of a mesh with vertices of its own, as it is encoded.
struct MeshBlock {
  std::uint64_t vertices = 0, faces = 0;
  Box box{};                                        // of the positions as they are written
  std::uint64_t vertex_bytes = 0, index_bytes = 0;  // packed
};

// A format that is made of blocks, whose sizes its header tells. Pure, like MeshEncoder.
class BlockEncoder {
 public:
  virtual ~BlockEncoder() = default;

  // Brings the faces of a block, by the numbers of its vertices below `vertices`, into the order in
  // which they are written.
  virtual void reorder(std::vector<std::uint32_t>& corners, std::size_t vertices) const = 0;

  // Appends to `out`. `corners` are numbers in `vertices`, three a face.
  virtual MeshBlock encode(const MeshShape& shape, std::span<const MeshVertex> vertices,
                           std::span<const std::uint32_t> corners,
                           std::vector<std::byte>& out) const = 0;

  // Hands what comes before the blocks, piece by piece, to `emit`. Throws Error(usage) where the
  // format cannot hold so much.
  virtual void header(const MeshShape& shape, std::span<const MeshBlock> blocks,
                      const std::function<void(std::string_view)>& emit) const = 0;
};

// Pure: the same calls give the same bytes, from any thread. A file is header(), all vertices, all
// faces, footer().
class MeshEncoder {
 public:
  virtual ~MeshEncoder() = default;

  // Throws Error(usage) where the format cannot hold so much.
  [[nodiscard]] virtual std::string header(const MeshShape& shape) const = 0;

  // Append to `out`. `first`: number of the first of them in the mesh. A format that has no
  // vertices of its own writes none.
  virtual void vertices(const MeshShape& shape, std::uint64_t first,
                        std::span<const MeshVertex> vertices,
                        std::vector<std::byte>& out) const = 0;

  // `corners` holds the positions of the faces' corners, or nothing where needs_corners() is false.
  virtual void faces(const MeshShape& shape, std::uint64_t first, std::span<const MeshFace> faces,
                     std::span<const Corners> corners, std::vector<std::byte>& out) const = 0;

  [[nodiscard]] virtual std::string footer(const MeshShape& /*shape*/) const { return {}; }

  // Why the format cannot hold an attribute that is one of those `wanted`, in words that its name
  // follows; empty where it can.
  [[nodiscard]] virtual std::string attribute_refusal(const Attribute& /*attribute*/,
                                                      std::span<const Attribute> /*wanted*/) const {
    return "the output's format holds no attributes:";
  }

  // Whether normals that are carried are written where others are, as MeshVertex::normal, not as
  // attributes.
  [[nodiscard]] virtual bool normals_apart() const { return false; }

  // Whether attributes are written as they are stored, whatever their numbers mean.
  [[nodiscard]] virtual bool keeps_numbers() const { return false; }

  [[nodiscard]] virtual bool needs_corners() const { return false; }
  // Whether header() and vertices() look at the shape's box and at whether it is closed.
  [[nodiscard]] virtual bool needs_survey() const { return false; }
  // Whether positions lose no more than a part of the mesh's size by being written, wherever it is.
  [[nodiscard]] virtual bool holds_doubles() const { return true; }
  // By which a position moves at most where positions are rounded on purpose: Encoding::quantize.
  [[nodiscard]] virtual double position_error(const MeshShape& /*shape*/) const { return 0; }
  // Where there is one, the file is its header and its blocks instead, and all of the above write
  // nothing.
  [[nodiscard]] virtual const BlockEncoder* blocks() const { return nullptr; }

  // Whether the file has the vertices of the mesh, each once and in their order.
  [[nodiscard]] bool numbers_vertices() const { return !needs_corners() && blocks() == nullptr; }
};

}  // namespace winnow
