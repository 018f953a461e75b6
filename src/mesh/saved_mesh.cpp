#include "mesh/saved_mesh.hpp"

#include "io/spool_records.hpp"

#include <string>

namespace winnow {

namespace {

constexpr const char* stage_key = "mesh.stage";
constexpr const char* vertices_part = ".vertices";
constexpr const char* faces_part = ".faces";
constexpr const char* state_part = ".state";
constexpr const char* attributes_part = ".attributes";

std::string stage_after(std::uint64_t rounds) {
  return "stage-" + std::to_string(rounds);
}

}  // namespace

void save_mesh(CheckpointDirectory& checkpoint, const StoredMesh& whole, std::uint64_t rounds,
               bool keep_first) {
  Manifest& manifest = checkpoint.manifest();
  if (manifest.has(stage_key)) {
    const std::string before = manifest.text(stage_key);
    for (const char* part : {state_part, attributes_part}) checkpoint.forget(before + part);
    if (!keep_first || before != stage_after(0)) {
      for (const char* part : {vertices_part, faces_part}) checkpoint.forget(before + part);
    }
  }
  const std::string stage = stage_after(rounds);
  checkpoint.save(stage + vertices_part, whole.vertices->records());
  checkpoint.save(stage + faces_part, *whole.faces);
  if (whole.state != nullptr) checkpoint.save(stage + state_part, *whole.state);
  if (whole.attributes != nullptr) checkpoint.save(stage + attributes_part, *whole.attributes);
  manifest.set(stage_key, stage);
  manifest.set("mesh.faces", whole.face_count);
}

StoredMesh load_mesh(Job& job, const CheckpointDirectory& checkpoint, std::uint64_t memory) {
  const Manifest& manifest = checkpoint.manifest();
  const std::string stage = manifest.text(stage_key);
  StoredMesh whole;
  if (checkpoint.has(stage + attributes_part)) {
    memory /= 2;
    whole.attributes = std::make_unique<Spool>(checkpoint.load(stage + attributes_part, memory));
  }
  whole.vertices =
      std::make_unique<VertexIndex>(job, checkpoint.load(stage + vertices_part, memory / 2));
  if (checkpoint.has(stage + state_part))
    whole.state = std::make_unique<Spool>(checkpoint.load(stage + state_part, memory / 4));
  whole.faces = std::make_unique<Spool>(checkpoint.load(stage + faces_part, memory / 4));
  whole.face_count = manifest.number("mesh.faces");
  return whole;
}

StoredMesh load_reference(Job& job, const CheckpointDirectory& checkpoint, std::uint64_t memory) {
  const std::string stage = stage_after(0);
  StoredMesh mesh;
  mesh.vertices =
      std::make_unique<VertexIndex>(job, checkpoint.load(stage + vertices_part, memory / 2));
  mesh.faces = std::make_unique<Spool>(checkpoint.load(stage + faces_part, memory / 2));
  mesh.face_count = record_count<FaceVertices>(*mesh.faces);
  return mesh;
}

}  // namespace winnow
