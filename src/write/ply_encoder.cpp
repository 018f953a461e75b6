// PLY, binary little-endian or ASCII, by Greg Turk's description of 1994.
#include <winnow/error.hpp>

#include "base/text.hpp"
#include "write/append_text.hpp"
#include "write/formats.hpp"

#include <cstring>

namespace winnow {

namespace {

constexpr std::uint64_t signed_indices = std::uint64_t{1} << 31;
constexpr std::uint64_t all_indices = std::uint64_t{1} << 32;

template <typename Real>
void encode_vertices(const MeshShape& shape, std::span<const MeshVertex> vertices,
                     std::vector<std::byte>& out) {
  std::size_t size = 3 * sizeof(Real) + (shape.normals ? 3 * sizeof(float) : 0);
  const std::size_t attributes = size;
  for (const Attribute& attribute : shape.attributes) size += size_of(attribute.type);
  std::size_t at = out.size();
  out.resize(at + size * vertices.size());
  for (const MeshVertex& vertex : vertices) {
    const std::array<Real, 3> position{static_cast<Real>(vertex.position[0]),
                                       static_cast<Real>(vertex.position[1]),
                                       static_cast<Real>(vertex.position[2])};
    std::memcpy(out.data() + at, position.data(), sizeof position);
    if (shape.normals)
      std::memcpy(out.data() + at + sizeof position, vertex.normal.data(), sizeof vertex.normal);
    std::byte* next = out.data() + at + attributes;
    for (std::size_t i = 0; i < shape.attributes.size(); ++i) {
      store_rounded(vertex.attributes[i], shape.attributes[i].type, next);
      next += size_of(shape.attributes[i].type);
    }
    at += size;
  }
}

void append_text_vertices(const MeshShape& shape, std::span<const MeshVertex> vertices,
                          std::vector<std::byte>& out) {
  for (const MeshVertex& vertex : vertices) {
    append_geometry(out, shape, vertex);
    for (std::size_t i = 0; i < shape.attributes.size(); ++i) {
      append_text(out, " ");
      append_rounded(out, vertex.attributes[i], shape.attributes[i].type);
    }
    append_text(out, "\n");
  }
}

class PlyEncoder final : public MeshEncoder {
 public:
  explicit PlyEncoder(bool ascii) : ascii_(ascii) {}

  [[nodiscard]] std::string header(const MeshShape& shape) const override {
    if (shape.vertices > all_indices) {
      throw Error(ErrorKind::usage, "PLY counts vertices with 32 bits, too few for " +
                                        grouped(shape.vertices) +
                                        "; ask for fewer faces, or for STL");
    }
    std::string text =
        std::string("ply\nformat ") + (ascii_ ? "ascii" : "binary_little_endian") + " 1.0\n";
    if (!shape.comment.empty()) text += "comment " + shape.comment + "\n";
    text += "element vertex " + std::to_string(shape.vertices) + "\n";
    const std::string real = shape.double_positions ? "double" : "float";
    for (const char* axis : {"x", "y", "z"}) text += "property " + real + " " + axis + "\n";
    if (shape.normals) {
      for (const char* axis : {"nx", "ny", "nz"})
        text += std::string("property float ") + axis + "\n";
    }
    for (const Attribute& attribute : shape.attributes)
      text += std::string("property ") + name_of(attribute.type) + " " + attribute.name + "\n";
    text += "element face " + std::to_string(shape.faces) + "\n";
    // Most readers know only int; uint is for what int cannot count.
    text += shape.vertices <= signed_indices ? "property list uchar int vertex_indices\n"
                                             : "property list uchar uint vertex_indices\n";
    return text + "end_header\n";
  }

  void vertices(const MeshShape& shape, std::uint64_t /*first*/,
                std::span<const MeshVertex> vertices, std::vector<std::byte>& out) const override {
    if (ascii_) {
      append_text_vertices(shape, vertices, out);
    } else if (shape.double_positions) {
      encode_vertices<double>(shape, vertices, out);
    } else {
      encode_vertices<float>(shape, vertices, out);
    }
  }

  void faces(const MeshShape& /*shape*/, std::uint64_t /*first*/, std::span<const MeshFace> faces,
             std::span<const Corners> /*corners*/, std::vector<std::byte>& out) const override {
    if (ascii_) return append_lines(out, faces);
    constexpr std::size_t size = 13;
    std::size_t at = out.size();
    out.resize(at + size * faces.size());
    for (const MeshFace& face : faces) {
      const std::array<std::uint32_t, 3> index{static_cast<std::uint32_t>(face.vertex[0]),
                                               static_cast<std::uint32_t>(face.vertex[1]),
                                               static_cast<std::uint32_t>(face.vertex[2])};
      out[at] = std::byte{3};
      std::memcpy(out.data() + at + 1, index.data(), sizeof index);
      at += size;
    }
  }

  [[nodiscard]] std::string attribute_refusal(
      const Attribute& /*attribute*/, std::span<const Attribute> /*wanted*/) const override {
    return {};
  }
  [[nodiscard]] bool keeps_numbers() const override { return true; }

 private:
  bool ascii_;
};

}  // namespace

const OutputFormat ply_output{.make = [](const Encoding& encoding) -> std::unique_ptr<MeshEncoder> {
                                return std::make_unique<PlyEncoder>(encoding.ascii);
                              },
                              .described =
                                  [](const Encoding& encoding) {
                                    return encoding.ascii ? "PLY ASCII"
                                                          : "PLY binary little-endian";
                                  },
                              .text = TextForm::by_choice};

}  // namespace winnow
