#include "support/refining.hpp"

#include "io/arena.hpp"
#include "io/spool_records.hpp"
#include "meshes.hpp"
#include "support/sources.hpp"
#include "support/stl_file.hpp"

#include <algorithm>

namespace winnow::test {

namespace {

WeldResult weld_source(Job& job, std::unique_ptr<ByteSource> source) {
  const std::uint64_t part = job.budget.total() / 8;
  const std::unique_ptr<MeshReader> reader =
      open_reader(job, std::move(source), Format::automatic, Access::repeatedly, {part, 8192});
  return in_arena(job, [&] {
    const WeldSettings settings{{}, !reader->facts().double_positions};
    return winnow::weld(job, *reader, settings, {part, part, part, {}},
                        reader->facts().faces.value_or(0));
  });
}

}  // namespace

WeldResult weld(Job& job, const std::string& path) {
  return weld_source(job, open_source(job, path));
}

WeldResult weld(Job& job, const std::vector<Triangle>& faces) {
  return weld_content(job, binary_stl(faces));
}

WeldResult weld_content(Job& job, const std::string& content) {
  return weld_source(job, std::make_unique<MemorySource>(content));
}

StoredMesh welded(Job& job, const std::string& path) {
  return weld(job, path).mesh;
}

StoredMesh welded(Job& job, const std::vector<Triangle>& faces) {
  return weld(job, faces).mesh;
}

std::vector<Triangle> triangles_of(const StoredMesh& mesh) {
  VertexIndex::Reader vertices(*mesh.vertices);
  std::vector<Triangle> all;
  for (const auto& [a, b, c] : read_records<FaceVertices>(*mesh.faces, 0, mesh.face_count))
    all.push_back({vertices.position(a), vertices.position(b), vertices.position(c)});
  return all;
}

std::string whale() {
  return test_data("whale_cranium.ply.zst");
}

std::string mountains() {
  return test_data("white_mountains.ply.zst");
}

Defects defects_of(const std::vector<FaceVertices>& faces) {
  struct Side {
    std::uint32_t low, high;
    bool along;
    auto operator<=>(const Side&) const = default;
  };
  Defects defects;
  std::vector<Side> sides;
  std::vector<FaceVertices> sorted = faces;
  for (FaceVertices& face : sorted) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = face[i];
      const std::uint32_t b = face[(i + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), a < b});
    }
    std::sort(face.begin(), face.end());
    defects.degenerate += face[0] == face[1] || face[1] == face[2];
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) defects.duplicates += sorted[i] == sorted[i - 1];
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
      ++end;
    defects.boundary_edges += end - i == 1;
    defects.crowded += end - i > 2;
    defects.discords += end - i == 2 && sides[i].along == sides[i + 1].along;
    i = end;
  }
  return defects;
}

TileMesh whole_tile(const PlainMesh& mesh) {
  std::vector<Point> positions;
  for (const IndexedVertex& vertex : mesh.vertices) positions.push_back(vertex.position);
  return {std::move(positions), mesh.faces, std::vector<std::uint8_t>(mesh.vertices.size(), 0)};
}

std::vector<FaceVertices> live_faces(const TileMesh& mesh) {
  std::vector<FaceVertices> faces;
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (!mesh.removed(f)) faces.push_back(mesh.face(f));
  }
  return faces;
}

RefineSettings down_to(std::uint64_t faces, std::uint64_t tile_faces) {
  RefineSettings settings;
  settings.faces = faces;
  settings.tile_faces = tile_faces;
  return settings;
}

RefineMemory divided(const Job& job) {
  const std::uint64_t left = job.budget.left();
  return {left / 2, left / 8, left / 4, left / 8};
}

RefinedPlain refined(const std::string& path, const RefineSettings& settings,
                     const JobSettings& job, const std::optional<RefineMemory>& memory) {
  TestJob test(job);
  return in_arena(test.job, [&] {
    const Refined refined =
        refine(test.job, welded(test.job, path), settings, memory.value_or(divided(test.job)));
    RefinedPlain out{plain(refined.mesh), refined.report};
    out.mesh.spilled = test.job.scratch.written();
    return out;
  });
}

}  // namespace winnow::test
