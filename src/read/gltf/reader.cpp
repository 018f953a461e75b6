// glTF 2.0 (Khronos, 2021), as GLB or as JSON: the triangles of the default scene, where its nodes
// place them.
#include "read/gltf/reader.hpp"

#include "base/text.hpp"
#include "read/buffered_reader.hpp"
#include "read/formats.hpp"
#include "read/gltf/accessor.hpp"
#include "read/gltf/attributes.hpp"
#include "read/gltf/bytes.hpp"
#include "read/gltf/instances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace winnow {

namespace {

// Triangles out of the indices of one primitive.
class GltfCorners {
 public:
  GltfCorners(GltfPrimitive::Mode mode, bool mirrored, std::uint64_t base, std::uint64_t vertices,
              BufferedMesh& mesh)
      : mode_(mode), mirrored_(mirrored), base_(base), vertices_(vertices), mesh_(mesh) {}

  void add(std::uint64_t index) {
    // Not another primitive's vertex.
    const std::uint32_t corner =
        index < vertices_ ? static_cast<std::uint32_t>(base_ + index) : no_vertex;
    ++seen_;
    if (mode_ == GltfPrimitive::Mode::triangles ? seen_ % 3 == 0 : seen_ >= 3) add_triangle(corner);
    if (seen_ == 1) first_ = corner;
    before_ = last_;
    last_ = corner;
  }

  // Returns how many indices were left over.
  std::uint64_t finish() {
    mesh_.add_triangles(triangles_);
    triangles_.clear();
    return mode_ == GltfPrimitive::Mode::triangles ? seen_ % 3 : 0;
  }

 private:
  void add_triangle(std::uint32_t corner) {
    std::uint32_t a = mode_ == GltfPrimitive::Mode::fan ? first_ : before_;
    std::uint32_t b = last_;
    if (mode_ == GltfPrimitive::Mode::strip) {
      // A repeated index only turns a strip around a corner; that is no face.
      if (a == b || b == corner || a == corner) return;
      if (seen_ % 2 == 0) std::swap(a, b);
    }
    if (mirrored_) std::swap(a, b);
    triangles_.insert(triangles_.end(), {a, b, corner});
    if (triangles_.size() < 3 * 4096) return;
    mesh_.add_triangles(triangles_);
    triangles_.clear();
  }

  GltfPrimitive::Mode mode_;
  bool mirrored_;
  std::uint64_t base_, vertices_;
  BufferedMesh& mesh_;
  std::uint64_t seen_ = 0;
  std::uint32_t first_ = 0, before_ = 0, last_ = 0;
  std::vector<std::uint32_t> triangles_;
};

class GltfParser {
 public:
  // `target`: that is added to positions, counted from 0.
  GltfParser(const GltfDocument& document, const GltfAttributes& attributes,
             std::optional<std::size_t> target, GltfBytes& bytes, BufferedMesh& mesh)
      : document_(document), attributes_(attributes), target_(target), bytes_(bytes), mesh_(mesh) {}

  void parse() {
    for (const GltfPlacedMesh& placed : document_.placed) {
      if (placed.instances) {
        add_instances(placed, *placed.instances);
      } else {
        add(placed.mesh, placed.to_world);
      }
    }
    if (document_.center) {
      const Point& center = *document_.center;
      mesh_.job().note("the centre that CESIUM_RTC gives was added to all positions: " +
                       shortest(center[0]) + " " + shortest(center[1]) + " " + shortest(center[2]));
    }
    for (const std::string& what : attributes_.unread) mesh_.pass_over(what);
    mesh_.leave_out_points(document_.other_points);
    if (document_.other_primitives > 0) {
      mesh_.job().note(grouped(document_.other_primitives) +
                       (document_.other_primitives == 1 ? " primitive" : " primitives") +
                       " of points or lines, or without positions, left out");
    }
    if (left_over_ > 0)
      mesh_.job().note(grouped(left_over_) + " indices are no whole triangle and were left out");
  }

 private:
  // What makes a vertex: accessors of positions and of what is offered, whether it is carried or
  // not, so that the same vertices come with and without.
  using VertexKey = std::array<std::optional<std::size_t>, 6>;

  void add_instances(const GltfPlacedMesh& placed, const GltfInstances& instances) {
    GltfInstanceReader reader(bytes_, document_, instances, mesh_.name());
    for (auto part = reader.next(); !part.empty(); part = reader.next()) {
      for (const GltfTransform& instance : part) {
        mesh_.job().progress.check_cancelled();
        add(placed.mesh, placed.to_world * instance);
      }
    }
  }

  void add(std::size_t mesh, const GltfTransform& to_world) {
    first_vertex_.clear();
    for (const GltfPrimitive& primitive : document_.meshes[mesh]) add(primitive, to_world);
  }

  void add(const GltfPrimitive& primitive, const GltfTransform& to_world) {
    const GltfTurn turn(to_world);
    const std::uint64_t base = first_vertex_of(primitive, to_world, turn);
    const std::uint64_t vertices = document_.accessors[primitive.positions].count;
    bytes_.begin_part();
    GltfCorners corners(primitive.mode, turn.mirrors(), base, vertices, mesh_);
    if (primitive.indices) {
      GltfElements indices(bytes_, document_, *primitive.indices, GltfUse::indices, mesh_.name());
      for (auto part = indices.next(); !part.empty(); part = indices.next()) {
        for (const double index : part) corners.add(static_cast<std::uint64_t>(index));
        mesh_.job().progress.advance(part.size() * sizeof(std::uint32_t));
      }
    } else {
      for (std::uint64_t i = 0; i < vertices; ++i) corners.add(i);
    }
    left_over_ += corners.finish();
  }

  // Primitives of a mesh may share their vertices.
  std::uint64_t first_vertex_of(const GltfPrimitive& primitive, const GltfTransform& to_world,
                                const GltfTurn& turn) {
    VertexKey key{primitive.positions};
    if (attributes_.normals) key[1] = primitive.normals;
    if (attributes_.colors) key[2] = primitive.colors;
    const GltfPrimitive::Target moves = moves_of(primitive);
    key[3] = moves.positions;
    if (attributes_.normals) key[4] = moves.normals;
    if (attributes_.colors) key[5] = moves.colors;
    const auto [known, is_new] = first_vertex_.try_emplace(key, mesh_.vertices());
    if (is_new) add_vertices(primitive, to_world, turn);
    return known->second;
  }

  [[nodiscard]] GltfPrimitive::Target moves_of(const GltfPrimitive& primitive) const {
    if (!target_ || *target_ >= primitive.targets.size()) return {};
    return primitive.targets[*target_];
  }

  void add_vertices(const GltfPrimitive& primitive, const GltfTransform& to_world,
                    const GltfTurn& turn) {
    const bool moved = to_world != gltf_identity;
    bytes_.begin_part();
    GltfElements positions(bytes_, document_, primitive.positions, GltfUse::positions,
                           mesh_.name());
    const GltfPrimitive::Target by = moves_of(primitive);
    GltfVertexAttributes others(bytes_, document_, attributes_, primitive, by, mesh_.carried(),
                                turn, mesh_.name());
    std::optional<GltfElements> moves;
    if (by.positions)
      moves.emplace(bytes_, document_, *by.positions, GltfUse::positions, mesh_.name());
    std::vector<double> xyz;
    std::vector<double> carried;
    for (auto part = positions.next(); !part.empty(); part = positions.next()) {
      xyz.assign(part.begin(), part.end());
      if (moves) {
        const std::span<const double> more = moves->next();
        for (std::size_t i = 0; i < xyz.size(); ++i) xyz[i] += more[i];
      }
      for (std::size_t i = 0; i < xyz.size() && moved; i += 3) {
        const Point p = transformed(to_world, {xyz[i], xyz[i + 1], xyz[i + 2]});
        std::copy(p.begin(), p.end(), xyz.begin() + static_cast<std::ptrdiff_t>(i));
      }
      others.next(xyz.size() / 3, carried);
      // Not a number is one of floats, too.
      const bool single = std::all_of(xyz.begin(), xyz.end(), [](double x) {
        return double{static_cast<float>(x)} == x || !std::isfinite(x);
      });
      mesh_.add_vertices(xyz, single, carried);
      mesh_.job().progress.advance(xyz.size() * sizeof(float));
    }
  }

  const GltfDocument& document_;
  const GltfAttributes& attributes_;
  std::optional<std::size_t> target_;
  GltfBytes& bytes_;
  BufferedMesh& mesh_;
  std::map<VertexKey, std::uint64_t> first_vertex_;  // of this node or instance
  std::uint64_t left_over_ = 0;
};

}  // namespace

std::unique_ptr<MeshReader> open_gltf_document(Job& job, std::unique_ptr<ByteSource> source,
                                               const ReaderMemory& memory,
                                               const AttributeRequest& wish, const GltfFile& file,
                                               const GltfAttributes& attributes,
                                               std::optional<std::size_t> target) {
  const auto parse = [&](ByteSource& from, std::size_t /*batch_faces*/, BufferedMesh& mesh) {
    const GltfOwnBuffer own = own_buffer_of(from, file);
    GltfBytes bytes(job, from, own.begin, own.bytes, file.document);
    GltfParser(file.document, attributes, target, bytes, mesh).parse();
  };
  return std::make_unique<BufferedReader>(job, std::move(source), memory, wish,
                                          file.binary ? "GLB" : "glTF", offer_of(attributes),
                                          parse);
}

namespace {

std::unique_ptr<MeshReader> open_gltf(Job& job, std::unique_ptr<ByteSource> source,
                                      const ReaderMemory& memory, const AttributeRequest& wish,
                                      bool /*asked*/) {
  const GltfFile file = peek_gltf(job, *source);
  return open_gltf_document(job, std::move(source), memory, wish, file,
                            attributes_of(file.document), {});
}

}  // namespace

const InputFormat gltf_input{
    .reading = Reading::whole_by_parts,
    .open = open_gltf,
    .probe =
        [](Job& job, ByteSource& source, bool /*asked*/, InputProbe& probe) {
          probe.facts.offer = offer_of(attributes_of(peek_gltf(job, source).document));
        },
    .certain = [](std::string_view head) { return head.starts_with("glTF"); },
    .match = match_gltf};

}  // namespace winnow
