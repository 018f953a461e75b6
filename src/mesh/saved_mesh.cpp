#include "mesh/saved_mesh.hpp"

#include "base/memory_shares.hpp"
#include "io/spool_records.hpp"

#include <string>

namespace winnow {

namespace {

constexpr const char* stage_key = "mesh.stage";
constexpr const char* vertices_part = ".vertices";
constexpr const char* faces_part = ".faces";
constexpr const char* state_part = ".state";
constexpr const char* attributes_part = ".attributes";
constexpr const char* map_part = ".map";

std::string stage_after(std::uint64_t rounds) {
  return "stage-" + std::to_string(rounds);
}

// Of each part so many times its bytes a vertex.
std::uint64_t vertex_memory(const MeshLayout& layout, std::uint64_t memory) {
  return MeshMemory::divide(memory).vertices / layout.vertex_bytes();
}

MeshLayout layout_in(const Manifest& manifest) {
  return {manifest.number("mesh.state_bytes"), manifest.number("mesh.attributes")};
}

std::string level_key(std::size_t level) {
  return "mesh.level-" + std::to_string(level);
}

// Whether the stage is the level that was kept last.
bool is_level(const Manifest& manifest, const std::string& stage) {
  std::size_t levels = 0;
  while (manifest.has(level_key(levels))) ++levels;
  return levels > 0 && manifest.text(level_key(levels - 1)) == stage;
}

// Vertices and faces.
StoredMesh load_surface(Job& job, const CheckpointDirectory& checkpoint, const std::string& stage,
                        const MeshLayout& layout, std::uint64_t memory) {
  StoredMesh mesh;
  mesh.layout = layout;
  mesh.vertices = std::make_unique<VertexIndex>(
      job, checkpoint.load(stage + vertices_part,
                           vertex_memory(layout, memory) * sizeof(IndexedVertex)));
  mesh.faces = std::make_unique<Spool>(
      checkpoint.load(stage + faces_part, MeshMemory::divide(memory).faces));
  mesh.face_count = record_count<FaceVertices>(*mesh.faces);
  return mesh;
}

}  // namespace

void save_mesh(CheckpointDirectory& checkpoint, const StoredMesh& whole, std::uint64_t rounds,
               bool keep_first) {
  Manifest& manifest = checkpoint.manifest();
  if (manifest.has(stage_key)) {
    const std::string before = manifest.text(stage_key);
    for (const char* part : {state_part, map_part}) checkpoint.forget(before + part);
    if (!is_level(manifest, before)) {
      checkpoint.forget(before + attributes_part);
      if (!keep_first || before != stage_after(0)) {
        for (const char* part : {vertices_part, faces_part}) checkpoint.forget(before + part);
      }
    }
  }
  const std::string stage = stage_after(rounds);
  checkpoint.save(stage + vertices_part, whole.vertices->records());
  checkpoint.save(stage + faces_part, *whole.faces);
  if (whole.state != nullptr) checkpoint.save(stage + state_part, *whole.state);
  if (whole.attributes != nullptr) checkpoint.save(stage + attributes_part, *whole.attributes);
  if (whole.map != nullptr) checkpoint.save(stage + map_part, *whole.map);
  manifest.set(stage_key, stage);
  manifest.set("mesh.state_bytes", std::uint64_t{whole.layout.state});
  manifest.set("mesh.attributes", std::uint64_t{whole.layout.attributes});
}

namespace {

StoredMesh load_stage(Job& job, const CheckpointDirectory& checkpoint, const std::string& stage,
                      const MeshLayout& layout, std::uint64_t memory) {
  StoredMesh mesh = load_surface(job, checkpoint, stage, layout, memory);
  const std::uint64_t each = vertex_memory(mesh.layout, memory);
  const auto load = [&](const char* part, std::size_t bytes) -> std::unique_ptr<Spool> {
    if (bytes == 0) return nullptr;
    return std::make_unique<Spool>(checkpoint.load(stage + part, each * bytes));
  };
  mesh.state = load(state_part, mesh.layout.state);
  mesh.attributes = load(attributes_part, mesh.layout.attribute_bytes());
  return mesh;
}

}  // namespace

void keep_level(CheckpointDirectory& checkpoint, std::size_t level) {
  checkpoint.manifest().set(level_key(level), checkpoint.manifest().text(stage_key));
}

StoredMesh load_level(Job& job, const CheckpointDirectory& checkpoint, std::size_t level,
                      std::uint64_t memory) {
  const Manifest& manifest = checkpoint.manifest();
  MeshLayout layout = layout_in(manifest);
  layout.state = 0;
  return load_stage(job, checkpoint, manifest.text(level_key(level)), layout, memory);
}

StoredMesh load_mesh(Job& job, const CheckpointDirectory& checkpoint, std::uint64_t memory) {
  const Manifest& manifest = checkpoint.manifest();
  const std::string stage = manifest.text(stage_key);
  StoredMesh mesh = load_stage(job, checkpoint, stage, layout_in(manifest), memory);
  if (checkpoint.has(stage + map_part))
    mesh.map =
        std::make_unique<Spool>(checkpoint.load(stage + map_part, share::round::map(memory)));
  return mesh;
}

StoredMesh load_reference(Job& job, const CheckpointDirectory& checkpoint, std::uint64_t memory) {
  return load_surface(job, checkpoint, stage_after(0), {}, memory);
}

}  // namespace winnow
