// STL: binary (80 bytes of text, a 32-bit count, 50 bytes a face) and ASCII.
#include "base/vector.hpp"
#include "write/append_text.hpp"
#include "write/formats.hpp"

#include <algorithm>
#include <cstring>

namespace winnow {

namespace {

// The normal and three corners.
using Facet = std::array<std::array<float, 3>, 4>;

Facet facet_of(const Corners& face) {
  const Triangle triangle{face[0], face[1], face[2]};
  const Point n = doubled_area(triangle);
  const double size = length(n);
  Facet facet{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    facet[0][axis] = size > 0 ? static_cast<float>(n[axis] / size) : 0.0F;
    for (std::size_t corner = 0; corner < 3; ++corner)
      facet[1 + corner][axis] = static_cast<float>(face[corner][axis]);
  }
  return facet;
}

class BinaryStlEncoder final : public MeshEncoder {
 public:
  [[nodiscard]] std::string header(const MeshShape& shape) const override {
    // Not "solid": that is how the ASCII form begins.
    std::string text = "binary STL";
    if (!shape.comment.empty()) text += ", " + shape.comment;
    text.resize(80, ' ');
    // A count beyond 32 bits is left at its highest value; readers then go by the file's size.
    const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(shape.faces, UINT32_MAX));
    text.resize(84);
    std::memcpy(text.data() + 80, &count, sizeof count);
    return text;
  }

  void vertices(const MeshShape& /*shape*/, std::uint64_t /*first*/,
                std::span<const MeshVertex> /*vertices*/,
                std::vector<std::byte>& /*out*/) const override {}

  void faces(const MeshShape& /*shape*/, std::uint64_t /*first*/,
             std::span<const MeshFace> /*faces*/, std::span<const Corners> corners,
             std::vector<std::byte>& out) const override {
    constexpr std::size_t size = 50;
    std::size_t at = out.size();
    out.resize(at + size * corners.size());
    for (const Corners& face : corners) {
      const Facet facet = facet_of(face);
      std::memcpy(out.data() + at, facet.data(), sizeof facet);
      at += size;
    }
  }

  [[nodiscard]] bool needs_corners() const override { return true; }
  [[nodiscard]] bool holds_doubles() const override { return false; }
};

class AsciiStlEncoder final : public MeshEncoder {
 public:
  [[nodiscard]] std::string header(const MeshShape& shape) const override {
    return "solid " + name_of(shape) + "\n";
  }

  void vertices(const MeshShape& /*shape*/, std::uint64_t /*first*/,
                std::span<const MeshVertex> /*vertices*/,
                std::vector<std::byte>& /*out*/) const override {}

  void faces(const MeshShape& /*shape*/, std::uint64_t /*first*/,
             std::span<const MeshFace> /*faces*/, std::span<const Corners> corners,
             std::vector<std::byte>& out) const override {
    for (const Corners& face : corners) {
      const Facet facet = facet_of(face);
      append_text(out, "facet normal ");
      append_triple(out, facet[0]);
      append_text(out, "\n outer loop\n");
      for (std::size_t corner = 1; corner < 4; ++corner) {
        append_text(out, "  vertex ");
        append_triple(out, facet[corner]);
        append_text(out, "\n");
      }
      append_text(out, " endloop\nendfacet\n");
    }
  }

  [[nodiscard]] std::string footer(const MeshShape& shape) const override {
    return "endsolid " + name_of(shape) + "\n";
  }

  [[nodiscard]] bool needs_corners() const override { return true; }
  [[nodiscard]] bool holds_doubles() const override { return false; }

 private:
  static std::string name_of(const MeshShape& shape) {
    return shape.comment.empty() ? "mesh" : shape.comment;
  }
};

}  // namespace

const OutputFormat stl_output{
    .make = [](const Encoding& encoding) -> std::unique_ptr<MeshEncoder> {
      if (encoding.ascii) return std::make_unique<AsciiStlEncoder>();
      return std::make_unique<BinaryStlEncoder>();
    },
    .described =
        [](const Encoding& encoding) { return encoding.ascii ? "STL ASCII" : "STL binary"; },
    .text = TextForm::by_choice,
    .doubles = false};

}  // namespace winnow
