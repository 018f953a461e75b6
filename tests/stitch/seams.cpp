// The borders of tiles do not show: along them faces are as dense, and as near to the original, as
// elsewhere.
#include "measure/surface_tree.hpp"
#include "support/files.hpp"
#include "support/program.hpp"
#include "support/refining.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

std::vector<NumberedFace> numbered_faces(const PlainMesh& mesh) {
  std::vector<NumberedFace> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) faces.push_back({mesh.triangle(f), f});
  return faces;
}

// Faces within so many rings of the borders between the tiles of the first round.
std::vector<bool> strip_of(const StoredMesh& whole, const PlainMesh& mesh, std::uint64_t tile_faces,
                           int rings) {
  const Tiling tiling(whole, tile_faces);
  REQUIRE(tiling.tiles() >= 10);
  std::vector<bool> near(mesh.vertices.size(), false);
  std::vector<bool> strip(mesh.faces.size(), false);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    strip[f] = tiling.tile_of(a) != tiling.tile_of(b) || tiling.tile_of(a) != tiling.tile_of(c);
  }
  for (int ring = 0; ring < rings; ++ring) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      if (!strip[f]) continue;
      for (const std::uint32_t v : mesh.faces[f]) near[v] = true;
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (const std::uint32_t v : mesh.faces[f]) {
        if (near[v]) strip[f] = true;
      }
    }
  }
  return strip;
}

// In the strip, and inside the tiles.
struct Measured {
  double strip = 0, inside = 0;
};

// Of the faces of the result, by the original face that each middle is nearest to.
Measured faces_by_place(const PlainMesh& result, const SurfaceTree& original,
                        const std::vector<bool>& strip) {
  Measured count;
  for (std::size_t f = 0; f < result.faces.size(); ++f) {
    const auto [a, b, c] = result.triangle(f);
    NearestFace nearest;
    original.search((1.0 / 3) * (a + b + c), nearest);
    (strip[nearest.number] ? count.strip : count.inside) += 1;
  }
  return count;
}

// The root of the mean squared distance of the original's corners from the result.
Measured distances_by_place(const PlainMesh& original, const std::vector<bool>& strip, Job& job,
                            const PlainMesh& result) {
  const std::vector<NumberedFace> faces = numbered_faces(result);
  const SurfaceTree tree(job, faces);
  NeighbourSearch search(tree);
  Measured sum;
  Measured count;
  for (std::size_t f = 0; f < original.faces.size(); f += 5) {
    NearestFace nearest;
    search.search(original.triangle(f)[0], nearest);
    (strip[f] ? sum.strip : sum.inside) += nearest.squared;
    (strip[f] ? count.strip : count.inside) += 1;
  }
  return {std::sqrt(sum.strip / count.strip), std::sqrt(sum.inside / count.inside)};
}

}  // namespace

TEST_CASE("along the borders of tiles faces are as dense and as near as elsewhere", "[long]") {
  // Large enough that each of both parts has thousands of faces, so that chance stays near one in a
  // hundred.
  const Directory directory;
  const std::string path = directory.file("scan.ply");
  generate("scan", 400'000, path);
  constexpr std::uint64_t wanted = 40'000;
  constexpr std::uint64_t tile_faces = 32'000;

  TestJob test;
  const StoredMesh whole = welded(test.job, path);
  const PlainMesh original = plain(whole);
  // An edge of the result is about as long as three of the original: two of them to either side.
  const std::vector<bool> strip = strip_of(whole, original, tile_faces, 6);
  const std::vector<NumberedFace> faces = numbered_faces(original);
  const SurfaceTree tree(test.job, faces);

  // Shapes differ from place to place: what counts is how it would be without borders.
  const PlainMesh tiled = refined(path, down_to(wanted, tile_faces)).mesh;
  const PlainMesh in_one = refined(path, down_to(wanted, 10'000'000)).mesh;
  CHECK(tiled.faces.size() == wanted);
  CHECK(in_one.faces.size() == wanted);
  const Measured count = faces_by_place(tiled, tree, strip);
  const Measured right = faces_by_place(in_one, tree, strip);
  CHECK(right.strip > 3000);
  CHECK(right.inside > 3000);
  CHECK(count.strip / right.strip == Approx(1).epsilon(0.05));
  CHECK(count.inside / right.inside == Approx(1).epsilon(0.05));

  const Measured far = distances_by_place(original, strip, test.job, tiled);
  const Measured best = distances_by_place(original, strip, test.job, in_one);
  CHECK(far.strip <= 1.05 * best.strip);
  CHECK(far.inside <= 1.05 * best.inside);
}

}  // namespace winnow
