// GLB with EXT_meshopt_compression, by meshoptimizer's own encoders: nothing is rounded beyond what
// a plain GLB has. Each block is a primitive of the one mesh.
#include <winnow/error.hpp>

#include "write/append.hpp"
#include "write/coarse_floats.hpp"
#include "write/glb_layout.hpp"
#include "write/vertex_colors.hpp"

#include <meshoptimizer.h>

namespace winnow {

namespace {

// Makes room for `bound` bytes, lets `encode` fill them, keeps what it filled, and goes on at a
// whole word.
template <typename Encode>
std::uint64_t append_encoded(std::vector<std::byte>& out, std::size_t bound, const Encode& encode) {
  const std::size_t begin = out.size();
  out.resize(begin + bound);
  const std::size_t bytes = encode(reinterpret_cast<unsigned char*>(out.data() + begin));
  if (bytes == 0)
    throw Error(ErrorKind::failed, "meshoptimizer could not encode a part of the mesh");
  out.resize(begin + bytes);
  out.resize(begin + whole_words(bytes));
  return bytes;
}

class PackedGlbEncoder final : public MeshEncoder, public BlockEncoder {
 public:
  explicit PackedGlbEncoder(const Encoding& encoding) : encoding_(encoding) {}

  // Blocks say it all.
  [[nodiscard]] std::string header(const MeshShape& /*shape*/) const override { return {}; }
  void vertices(const MeshShape& /*shape*/, std::uint64_t /*first*/,
                std::span<const MeshVertex> /*vertices*/,
                std::vector<std::byte>& /*out*/) const override {}
  void faces(const MeshShape& /*shape*/, std::uint64_t /*first*/,
             std::span<const MeshFace> /*faces*/, std::span<const Corners> /*corners*/,
             std::vector<std::byte>& /*out*/) const override {}

  [[nodiscard]] bool needs_survey() const override { return true; }
  [[nodiscard]] std::string attribute_refusal(const Attribute& attribute,
                                              std::span<const Attribute> wanted) const override {
    return refusal_but_for_colors(attribute, wanted, true);
  }
  [[nodiscard]] bool normals_apart() const override { return true; }
  [[nodiscard]] double position_error(const MeshShape& shape) const override {
    return GlbLayout(shape, encoding_).place.error();
  }
  [[nodiscard]] const BlockEncoder* blocks() const override { return this; }

  // As few vertices as possible are fetched twice, by a graphics card and by the packed indices: a
  // quarter of their bytes is spared, and one in ten of the file's.
  void reorder(std::vector<std::uint32_t>& corners, std::size_t vertices) const override {
    meshopt_optimizeVertexCache(corners.data(), corners.data(), corners.size(), vertices);
  }

  MeshBlock encode(const MeshShape& shape, std::span<const MeshVertex> vertices,
                   std::span<const std::uint32_t> corners,
                   std::vector<std::byte>& out) const override {
    const GlbLayout layout(shape, encoding_);
    MeshBlock block{vertices.size(), corners.size() / 3};
    for (const MeshVertex& vertex : vertices) block.box.add(vertex.position);
    block.box = written_box(block.box, layout);
    std::vector<std::byte> plain;
    plain.reserve(vertices.size() * layout.stride);
    append_glb_vertices(shape, layout, vertices, plain);
    const std::size_t vertex_bound =
        meshopt_encodeVertexBufferBound(vertices.size(), layout.stride);
    block.vertex_bytes = append_encoded(out, vertex_bound, [&](unsigned char* into) {
      return meshopt_encodeVertexBuffer(into, vertex_bound, plain.data(), vertices.size(),
                                        layout.stride);
    });
    const std::size_t index_bound = meshopt_encodeIndexBufferBound(corners.size(), vertices.size());
    block.index_bytes = append_encoded(out, index_bound, [&](unsigned char* into) {
      return meshopt_encodeIndexBuffer(into, index_bound, corners.data(), corners.size());
    });
    return block;
  }

  void header(const MeshShape& shape, std::span<const MeshBlock> blocks,
              const Emit& emit) const override {
    check_floats(shape.box);
    emit_glb_head(shape, GlbLayout(shape, encoding_), blocks, true, emit);
  }

 private:
  Encoding encoding_;
};

}  // namespace

std::unique_ptr<MeshEncoder> make_packed_glb_encoder(const Encoding& encoding) {
  return std::make_unique<PackedGlbEncoder>(encoding);
}

}  // namespace winnow
