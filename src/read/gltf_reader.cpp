// glTF 2.0 (Khronos, 2021), as GLB or as JSON: the triangles of the default scene, where its nodes place
// them.
#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/formats.hpp"
#include "read/gltf_accessor.hpp"
#include "read/gltf_bytes.hpp"
#include "read/gltf_document.hpp"
#include "read/kept_reader.hpp"
#include "read/ply_scalar.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace winnow {

namespace {

// Where the parts of a file stand.
struct GltfParts {
  std::uint64_t json_begin = 0, json_bytes = 0;
  std::uint64_t own_begin = 0, own_bytes = 0;  // the GLB's buffer
};

[[noreturn]] void fail(const ByteSource& source, const std::string& what) {
  throw Error(ErrorKind::bad_input, "'" + source.name() + "' " + what);
}

GltfParts find_parts(ByteSource& source) {
  constexpr std::uint32_t json = 0x4E4F534A;
  constexpr std::uint32_t binary = 0x004E4942;
  const std::uint64_t size = source.size().value_or(0);
  source.seek(0);
  const Block head = source.take(20);
  const auto word = [](const Block& block, std::size_t at) {
    return load<std::uint32_t>(block.bytes.data() + at, false);
  };
  if (head.bytes.size() < 4 || word(head, 0) != 0x46546C67) return {0, size, 0, 0};
  if (head.bytes.size() < 20) fail(source, "ends inside its GLB header: it was cut short");
  if (word(head, 4) != 2) fail(source, "is GLB of version " + grouped(word(head, 4)) + "; version 2 is read");
  if (word(head, 8) > size) {
    fail(source, "should have " + grouped(word(head, 8)) + " bytes by its GLB header, but has " +
                     grouped(size) + ": it was cut short");
  }
  if (word(head, 16) != json || word(head, 12) > size - 20) fail(source, "does not begin with its JSON");
  GltfParts parts{20, word(head, 12), 0, 0};
  const std::uint64_t behind = (parts.json_begin + parts.json_bytes + 3) / 4 * 4;
  if (behind > size || size - behind < 8) return parts;
  source.seek(behind);
  const Block next = source.take(8);
  if (next.bytes.size() < 8 || word(next, 4) != binary) return parts;
  if (word(next, 0) > size - behind - 8) fail(source, "ends inside its buffer: it was cut short");
  parts.own_begin = behind + 8;
  parts.own_bytes = word(next, 0);
  return parts;
}

// Triangles out of the indices of one primitive.
class Corners {
 public:
  Corners(GltfPrimitive::Mode mode, bool mirrored, std::uint64_t base, std::uint64_t vertices, KeptMesh& mesh)
      : mode_(mode), mirrored_(mirrored), base_(base), vertices_(vertices), mesh_(mesh) {}

  void add(std::uint64_t index) {
    // Not another primitive's vertex.
    const std::uint32_t corner = index < vertices_ ? static_cast<std::uint32_t>(base_ + index) : no_vertex;
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
  KeptMesh& mesh_;
  std::uint64_t seen_ = 0;
  std::uint32_t first_ = 0, before_ = 0, last_ = 0;
  std::vector<std::uint32_t> triangles_;
};

class GltfParser {
 public:
  GltfParser(const GltfDocument& document, GltfBytes& bytes, KeptMesh& mesh)
      : document_(document), bytes_(bytes), mesh_(mesh) {}

  void parse() {
    for (const GltfPlacedMesh& placed : document_.placed) {
      first_vertex_.clear();
      for (const GltfPrimitive& primitive : document_.meshes[placed.mesh]) add(primitive, placed.to_world);
    }
    for (const std::string& what : document_.unread) mesh_.pass_over(what);
    if (document_.other_primitives > 0) {
      mesh_.job().note(grouped(document_.other_primitives) +
                       (document_.other_primitives == 1 ? " primitive" : " primitives") +
                       " of points or lines, or without positions, left out");
    }
    if (left_over_ > 0)
      mesh_.job().note(grouped(left_over_) + " indices are no whole triangle and were left out");
  }

 private:
  void add(const GltfPrimitive& primitive, const GltfTransform& to_world) {
    const auto known = first_vertex_.find(primitive.positions);
    const std::uint64_t base =
        known != first_vertex_.end() ? known->second : add_vertices(primitive, to_world);
    const std::uint64_t vertices = document_.accessors[primitive.positions].count;
    Corners corners(primitive.mode, mirrors(to_world), base, vertices, mesh_);
    if (primitive.indices) {
      GltfElements indices(bytes_, document_, *primitive.indices, 1, mesh_.name());
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
  std::uint64_t add_vertices(const GltfPrimitive& primitive, const GltfTransform& to_world) {
    const std::uint64_t base = mesh_.vertices();
    first_vertex_[primitive.positions] = base;
    const bool moved = to_world != gltf_identity;
    GltfElements positions(bytes_, document_, primitive.positions, 3, mesh_.name());
    std::vector<double> xyz;
    for (auto part = positions.next(); !part.empty(); part = positions.next()) {
      xyz.assign(part.begin(), part.end());
      for (std::size_t i = 0; i < xyz.size() && moved; i += 3) {
        const std::array<double, 3> p{xyz[i], xyz[i + 1], xyz[i + 2]};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto& row = to_world[axis];
          xyz[i + axis] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
        }
      }
      // Not a number is one of floats, too.
      const bool single = std::all_of(xyz.begin(), xyz.end(), [](double x) {
        return double{static_cast<float>(x)} == x || !std::isfinite(x);
      });
      mesh_.add_vertices(xyz, single);
      mesh_.job().progress.advance(xyz.size() * sizeof(float));
    }
    return base;
  }

  // By the specification, triangles are turned with what they are mirrored by.
  static bool mirrors(const GltfTransform& t) {
    return t[0][0] * (t[1][1] * t[2][2] - t[1][2] * t[2][1]) -
               t[0][1] * (t[1][0] * t[2][2] - t[1][2] * t[2][0]) +
               t[0][2] * (t[1][0] * t[2][1] - t[1][1] * t[2][0]) <
           0;
  }

  const GltfDocument& document_;
  GltfBytes& bytes_;
  KeptMesh& mesh_;
  std::map<std::size_t, std::uint64_t> first_vertex_;  // of accessors read for this node
  std::uint64_t left_over_ = 0;
};

void parse_gltf_file(ByteSource& source, std::size_t /*batch_faces*/, KeptMesh& mesh) {
  const GltfParts parts = find_parts(source);
  Budget& budget = mesh.job().budget;
  const Reservation text_memory = budget.reserve(parts.json_bytes, "the JSON of a glTF");
  Reservation json_memory;
  GltfDocument document;
  {
    source.seek(parts.json_begin);
    const Block block = source.take(parts.json_bytes);
    const std::string_view json(reinterpret_cast<const char*>(block.bytes.data()), block.bytes.size());
    json_memory = budget.reserve(memory_to_parse_gltf(json), "the JSON of a glTF");
    document = parse_gltf(json, source.name());
    block.check_intact(source.name());
  }
  GltfBytes bytes(mesh.job(), source, parts.own_begin, parts.own_bytes, document);
  GltfParser(document, bytes, mesh).parse();
}

}  // namespace

bool is_gltf(std::string_view head) {
  if (head.starts_with("glTF")) return true;
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || head[first] != '{') return false;
  for (const char* key : {"\"asset\"", "\"accessors\"", "\"bufferViews\"", "\"buffers\"", "\"meshes\"",
                          "\"nodes\"", "\"scenes\""}) {
    if (head.find(key) != std::string_view::npos) return true;
  }
  return false;
}

std::unique_ptr<MeshReader> open_gltf(Job& job, std::unique_ptr<ByteSource> source,
                                      const ReaderMemory& memory, const AttributeWish& wish,
                                      const AttributeOffer& offer) {
  const bool binary = source->peek(4).bytes.size() == 4 &&
                      load<std::uint32_t>(source->peek(4).bytes.data(), false) == 0x46546C67;
  return std::make_unique<KeptReader>(job, std::move(source), memory, wish, binary ? "GLB" : "glTF", offer,
                                      parse_gltf_file);
}

}  // namespace winnow
