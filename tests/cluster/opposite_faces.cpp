// Of faces that stand as often in one sense as in the other, one side of the surface is left: that
// of what is beside them, else that of the first face in the input.
#include "io/arena.hpp"
#include "support/ply_file.hpp"
#include "support/refining.hpp"
#include "support/sources.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

std::size_t facing_inwards(const PlainMesh& mesh) {
  std::size_t inwards = 0;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Triangle face = mesh.triangle(i);
    inwards += dot(area_vector(face), face[0] + face[1] + face[2]) < 0 ? 1 : 0;
  }
  return inwards;
}

// The lowest corner first.
Triangle begun_lowest(Triangle face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

struct Senses {
  Triangle first{};  // of the faces
  int count = 0, opposite = 0;
};

// What is left by the definition, in ascending order, but for faces of which as many have either
// sense.
std::vector<Triangle> left_of(const std::vector<Triangle>& faces, std::set<Triangle>& even,
                              std::uint64_t& pairs) {
  std::map<Triangle, Senses> all;  // by corners in ascending order
  for (const Triangle& face : faces) {
    Triangle corners = face;
    std::sort(corners.begin(), corners.end());
    Senses& senses = all[corners];
    if (senses.count == 0) senses.first = begun_lowest(face);
    ++(begun_lowest(face) == senses.first ? senses.count : senses.opposite);
  }
  std::vector<Triangle> left;
  pairs = 0;
  for (const auto& [corners, senses] : all) {
    if (senses.count == senses.opposite) {
      even.insert(corners);
    } else {
      left.push_back(senses.count > senses.opposite ? senses.first
                                                    : begun_lowest(turned(senses.first)));
    }
    pairs += static_cast<std::uint64_t>(std::min(senses.count, senses.opposite));
  }
  std::sort(left.begin(), left.end());
  return left;
}

std::vector<Triangle> in_order(const PlainMesh& mesh, const std::set<Triangle>& without = {}) {
  std::vector<Triangle> faces;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    Triangle corners = mesh.triangle(i);
    faces.push_back(begun_lowest(corners));
    std::sort(corners.begin(), corners.end());
    if (without.contains(corners)) faces.pop_back();
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

TEST_CASE("of a surface with two sides the first is left, as a whole") {
  const std::vector<Triangle> outside = ball(30);
  for (const bool inside_first : {false, true}) {
    for (const bool by_turns : {false, true}) {
      CAPTURE(inside_first, by_turns);
      std::vector<Triangle> faces;
      for (const bool second : {false, true}) {
        for (const Triangle& face : outside) {
          const bool inside = second != inside_first;
          if (by_turns && second) continue;
          faces.push_back(inside ? turned(face) : face);
          if (by_turns) faces.push_back(inside ? face : turned(face));
        }
      }
      TestJob test;
      const PlainMesh mesh = plain(weld(test.job, faces));
      CHECK(mesh.faces.size() == outside.size());
      CHECK(mesh.fused == outside.size());
      CHECK(facing_inwards(mesh) == (inside_first ? outside.size() : 0));
      CHECK(defects_of(mesh.faces).discords == 0);
    }
  }
}

TEST_CASE("most faces decide the sense, whatever the order, memory and number of threads") {
  Random random(910);
  std::vector<Triangle> faces;
  for (const Triangle& face : as_floats(ball(60))) {
    for (std::uint64_t copies = random.between(1, 3); copies > 0; --copies) faces.push_back(face);
    for (std::uint64_t copies = random.below(4); copies > 0; --copies)
      faces.push_back(turned(face));
  }
  random.shuffle(faces);
  std::uint64_t pairs = 0;
  std::set<Triangle> even;
  const std::vector<Triangle> right = left_of(faces, even, pairs);
  std::vector<PlainMesh> all;
  for (const unsigned threads : {1U, 4U}) {
    for (const std::uint64_t memory : {std::uint64_t{4} << 20, std::uint64_t{512} << 20}) {
      CAPTURE(threads, memory);
      TestJob test({.memory = memory, .threads = threads});
      all.push_back(plain(weld(test.job, faces)));
      CHECK((in_order(all.back(), even) == right));
      CHECK(all.back().fused == pairs);
      CHECK(difference(all.front(), all.back()) == "");
      CHECK((test.job.scratch.written() > 0) == (memory < std::uint64_t{64} << 20));
    }
  }
}

TEST_CASE("whatever the order of each pair, the side of the first face is left everywhere") {
  Random random(912);
  const std::vector<Triangle> outside = ball(30);
  for (int run = 0; run < 4; ++run) {
    std::vector<Triangle> faces = outside;
    for (Triangle& face : faces) face = random.chance(0.5) ? turned(face) : face;
    for (const Triangle& face : std::vector(faces)) faces.push_back(turned(face));
    if (run % 2 == 1) random.shuffle(faces);
    const bool inwards = dot(area_vector(faces[0]), faces[0][0] + faces[0][1] + faces[0][2]) < 0;
    // Of little memory, most is sorted in scratch.
    TestJob test({.memory = std::uint64_t{run < 2 ? 512U : 4U} << 20});
    const PlainMesh mesh = plain(weld(test.job, faces));
    CHECK(mesh.faces.size() == outside.size());
    CHECK(facing_inwards(mesh) == (inwards ? outside.size() : 0));
  }
}

TEST_CASE("faces of two senses take the side of those that they join") {
  Random random(913);
  std::vector<Triangle> faces;
  for (const Triangle& face : ball(30)) {
    const bool twice = face[0][2] > 0.3;
    const bool inwards = twice && random.chance(0.5);
    faces.push_back(inwards ? turned(face) : face);
    if (twice) faces.insert(faces.begin(), turned(faces.back()));
  }
  TestJob test;
  CHECK(facing_inwards(plain(weld(test.job, faces))) == 0);
}

TEST_CASE("equal faces in one sense become one and are no pair") {
  std::vector<Triangle> faces = ball(20);
  const std::size_t single = faces.size();
  for (std::size_t i = 0; i < single; ++i) faces.push_back({faces[i][1], faces[i][2], faces[i][0]});
  TestJob test;
  const PlainMesh mesh = plain(weld(test.job, faces));
  CHECK(mesh.faces.size() == single);
  CHECK(mesh.fused == 0);
  CHECK(facing_inwards(mesh) == 0);
}

TEST_CASE("the first face is known where the reader sorts them") {
  // A long strip of a grid, so that the vertices of each face are near each other in the file.
  constexpr std::int64_t width = 30;
  constexpr std::int64_t length = 1000;
  Random random(911);
  Polygons mesh;
  for (std::int64_t i = 0; i < width * length; ++i) {
    mesh.vertices.push_back(
        {static_cast<double>(i / width), static_cast<double>(i % width), random.unit()});
  }
  for (std::int64_t i = 0; i + width + 1 < width * length; ++i) {
    if (i % width == width - 1) continue;
    mesh.faces.push_back({i, i + width, i + width + 1});
    mesh.faces.push_back({i + width + 1, i + width, i});
  }
  random.shuffle(mesh.faces);
  const std::string file = ply_file(mesh, {});
  std::vector<PlainMesh> welded_meshes;
  for (const ReaderMemory& memory :
       {ReaderMemory{std::uint64_t{32} << 20, 8192, true}, {std::uint64_t{1} << 17, 1000, true}}) {
    TestJob test({.threads = 3});
    const auto reader = open_reader(test.job, std::make_unique<MemorySource>(file),
                                    Format::automatic, Access::repeatedly, memory);
    const std::uint64_t part = std::uint64_t{32} << 20;
    welded_meshes.push_back(plain(in_arena(test.job, [&] {
      return weld(test.job, *reader, {}, {part, part, part, {}}, mesh.faces.size());
    })));
    const bool sorted = memory.vertices < std::uint64_t{1} << 20;
    CHECK((test.job.scratch.written() >= 16 * mesh.faces.size()) == sorted);
  }
  CHECK(welded_meshes[0].fused == mesh.faces.size() / 2);
  CHECK(difference(welded_meshes[0], welded_meshes[1]) == "");
  // No two faces share an edge, so each is by itself.
  const PlainMesh& sorted = welded_meshes[1];
  std::map<Triangle, bool> first;
  for (const auto& face : mesh.faces) {
    Triangle corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        corners[i][axis] =
            static_cast<float>(mesh.vertices[static_cast<std::size_t>(face[i])][axis]);
    }
    if (!first.contains(begun_lowest(turned(corners)))) first.emplace(begun_lowest(corners), true);
  }
  std::size_t wrong = 0;
  for (const Triangle& face : in_order(sorted)) wrong += first.contains(face) ? 0 : 1;
  CHECK(wrong == 0);
}

}  // namespace winnow
