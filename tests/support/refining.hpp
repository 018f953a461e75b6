// Meshes that edges are collapsed in, called directly, and what makes their results sound.
#pragma once

#include "cluster/welder.hpp"
#include "decimate/decimation.hpp"
#include "stitch/refine.hpp"
#include "support/clustering.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace winnow::test {

// A mesh of tests/data or of `winnow generate`, welded.
StoredMesh welded(Job& job, const std::string& path);
StoredMesh welded(Job& job, const std::vector<Triangle>& faces);
// The same with what was counted; and of a file's content.
WeldResult weld(Job& job, const std::string& path);
WeldResult weld(Job& job, const std::vector<Triangle>& faces);
WeldResult weld_content(Job& job, const std::string& content);

// The whale, the elevation tile.
std::string whale();
std::string mountains();

// Edges with one face, and with more than two; the same face twice; a vertex twice in a face.
struct Defects {
  std::uint64_t boundary_edges = 0, crowded = 0, duplicates = 0, degenerate = 0;
  // Edges that two faces pass in the same direction.
  std::uint64_t discords = 0;
};
Defects defects_of(const std::vector<FaceVertices>& faces);

// The faces of a mesh in its order.
std::vector<Triangle> triangles_of(const StoredMesh& mesh);

// One tile of everything.
TileMesh whole_tile(const PlainMesh& mesh);

// Down to so many faces in tiles of this size.
RefineSettings down_to(std::uint64_t faces, std::uint64_t tile_faces);

// What is left of a tile.
std::vector<FaceVertices> live_faces(const TileMesh& mesh);

// Refined with parts of the budget as the pipeline divides it.
struct RefinedPlain {
  PlainMesh mesh;
  RefineReport report;
};
RefineMemory divided(const Job& job);
RefinedPlain refined(const std::string& path, const RefineSettings& settings,
                     const JobSettings& job = {}, const std::optional<RefineMemory>& memory = {});

}  // namespace winnow::test
