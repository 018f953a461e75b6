// Binary STL: 80 bytes of text, a 32-bit count, 50 bytes a face.
#include <winnow/error.hpp>

#include "base/text.hpp"
#include "write/append.hpp"
#include "write/mesh_encoder.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace winnow {

namespace {

class StlEncoder final : public MeshEncoder {
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

  void vertices(const MeshShape& /*shape*/, std::span<const MeshVertex> /*vertices*/,
                std::vector<std::byte>& /*out*/) const override {}

  void faces(const MeshShape& /*shape*/, std::span<const MeshFace> /*faces*/,
             std::span<const Corners> corners, std::vector<std::byte>& out) const override {
    constexpr std::size_t size = 50;
    std::size_t at = out.size();
    out.resize(at + size * corners.size());
    for (const Corners& face : corners) {
      std::array<float, 12> numbers{};
      const auto& [a, b, c] = face;
      const std::array<double, 3> u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
      const std::array<double, 3> v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
      const std::array<double, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                    u[0] * v[1] - u[1] * v[0]};
      const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        numbers[axis] = length > 0 ? static_cast<float>(n[axis] / length) : 0.0F;
        for (std::size_t corner = 0; corner < 3; ++corner) {
          numbers[3 + 3 * corner + axis] = static_cast<float>(face[corner][axis]);
        }
      }
      std::memcpy(out.data() + at, numbers.data(), sizeof numbers);
      at += size;
    }
  }

  [[nodiscard]] bool needs_corners() const override { return true; }
};

}  // namespace

std::unique_ptr<MeshEncoder> make_stl_encoder() {
  return std::make_unique<StlEncoder>();
}

}  // namespace winnow
