// Vertices whose faces are not one fan, against a walk around each.
#include "stitch/damage.hpp"

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/program.hpp"
#include "support/random.hpp"
#include "support/refining.hpp"
#include "support/tile_meshes.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

struct Sorted {
  std::set<std::uint32_t> damaged, at_boundaries;
};

// By joining the faces around a vertex that share an edge.
Sorted looked_at(const std::vector<FaceVertices>& faces) {
  std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 2>>> sides;
  for (const FaceVertices& face : faces) {
    for (std::size_t i = 0; i < 3; ++i)
      sides[face[i]].push_back({face[(i + 1) % 3], face[(i + 2) % 3]});
  }
  Sorted sorted;
  for (const auto& [vertex, around] : sides) {
    std::map<std::uint32_t, int> leaves;
    std::map<std::uint32_t, int> arrives;
    for (const auto& [from, to] : around) {
      ++leaves[from];
      ++arrives[to];
    }
    bool good = true;
    int begins = 0;
    for (const auto& [end, times] : leaves) {
      good = good && times == 1;
      begins += arrives.contains(end) ? 0 : 1;
    }
    for (const auto& [end, times] : arrives) good = good && times == 1;
    // How far one walk goes.
    std::set<std::uint32_t> met{around.front()[0], around.front()[1]};
    for (std::size_t before = 0; before != met.size();) {
      before = met.size();
      for (const auto& [from, to] : around) {
        if (met.contains(from) || met.contains(to)) met.insert({from, to});
      }
    }
    for (const auto& [from, to] : around) good = good && met.contains(from);
    if (!good || begins > 1) {
      sorted.damaged.insert(vertex);
    } else if (begins == 1) {
      sorted.at_boundaries.insert(vertex);
    }
  }
  return sorted;
}

std::vector<FaceVertices> faces_of(const StoredMesh& mesh) {
  std::vector<FaceVertices> faces(mesh.face_count);
  mesh.faces->read(0, std::as_writable_bytes(std::span(faces)));
  return faces;
}

void check_damage(Job& job, const StoredMesh& whole) {
  const Sorted right = looked_at(faces_of(whole));
  const Damage found = *find_damage(job, whole, nullptr, UINT64_MAX, 0, std::uint64_t{1} << 26);
  CHECK(std::vector(right.damaged.begin(), right.damaged.end()) == found.vertices);
  CHECK(std::vector(right.at_boundaries.begin(), right.at_boundaries.end()) == found.at_boundaries);
  const std::size_t told = found.vertices.size() + found.at_boundaries.size();
  CHECK(find_damage(job, whole, nullptr, told, 0, std::uint64_t{1} << 26).has_value());
  if (told > 0)
    CHECK_FALSE(find_damage(job, whole, nullptr, told - 1, 0, std::uint64_t{1} << 26).has_value());
}

}  // namespace

TEST_CASE("damage is found at random faces") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const std::vector<FaceVertices> faces =
        random_mesh(random, static_cast<VertexNumber>(4 + random.below(30)), 60);
    std::vector<Triangle> triangles;
    std::vector<Point> positions(64);
    for (Point& p : positions) p = {random.unit(), random.unit(), random.unit()};
    for (const auto& [a, b, c] : faces)
      triangles.push_back({positions[a], positions[b], positions[c]});
    TestJob test;
    check_damage(test.job, welded(test.job, triangles));
  }
}

TEST_CASE("damage is found in several tiles") {
  TestJob test;
  const Directory directory;
  for (const char* what : {"scan", "terrain"}) {
    const std::string input = directory.file("in.ply");
    generate(what, 150'000, input);
    check_damage(test.job, welded(test.job, input));
    ::unlink(input.c_str());
  }
}

TEST_CASE("a whale has no damage") {
  TestJob test;
  const StoredMesh whole = welded(test.job, whale());
  const Damage damage = *find_damage(test.job, whole, nullptr, 0, 0, std::uint64_t{1} << 26);
  CHECK(damage.vertices.empty());
  CHECK(damage.at_boundaries.empty());
}

}  // namespace winnow::test
