// The tree names the nearest face, as looking at all of them does.
#include "measure/surface_tree.hpp"

#include "support/job.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

Point random_point(test::Random& random, double half) {
  return {random.real(-half, half), random.real(-half, half), random.real(-half, half)};
}

std::vector<NumberedFace> random_faces(test::Random& random, std::size_t count, const Point& centre,
                                       double size) {
  std::vector<NumberedFace> faces;
  for (std::size_t i = 0; i < count; ++i) {
    const Point at = centre + random_point(random, 1);
    faces.push_back(
        {{at, at + random_point(random, size), at + random_point(random, size)}, 1000 + i});
  }
  random.shuffle(faces);
  return faces;
}

NearestFace by_looking_at_all(const std::vector<NumberedFace>& faces, const Point& point) {
  NearestFace best;
  for (const NumberedFace& face : faces) {
    const NearestFace near = distance_to(face, point);
    if (best.farther_than(near.squared, near.number)) best = near;
  }
  return best;
}

}  // namespace

TEST_CASE("the tree finds what looking at all faces finds, to the bit") {
  test::Random random(710);
  // Near the origin, and as far as maps are.
  for (const Point& centre : {Point{0, 0, 0}, Point{431000, 5412000, 300}}) {
    for (const double size : {1e-3, 0.1, 2.0}) {
      const std::vector<NumberedFace> faces = random_faces(random, 3000, centre, size);
      test::TestJob test;
      const SurfaceTree tree(test.job, faces);
      for (int round = 0; round < 300; ++round) {
        const double reach = round % 3 == 0 ? 50 : 1.2;
        const Point point = centre + random_point(random, reach);
        const NearestFace right = by_looking_at_all(faces, point);
        NearestFace found;
        CHECK(tree.search(point, found));
        CHECK(found.squared == right.squared);
        CHECK(found.number == right.number);
        // Beginning with some face changes nothing; beginning with the right one finds no better.
        NearestFace guessed = distance_to(faces[random.below(faces.size())], point);
        tree.search(point, guessed);
        CHECK(guessed.number == right.number);
        NearestFace known = right;
        CHECK_FALSE(tree.search(point, known));
      }
    }
  }
}

TEST_CASE("of equally near faces the lowest number is named") {
  std::vector<NumberedFace> faces;
  for (std::uint64_t number : {7, 3, 9, 5})
    faces.push_back({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, number});
  test::TestJob test;
  const SurfaceTree tree(test.job, faces);
  NearestFace found;
  CHECK(tree.search({0.2, 0.2, 1}, found));
  CHECK(found.number == 3);
  CHECK(found.squared == 1);
}

TEST_CASE("a search may stop once it is near enough") {
  test::Random random(711);
  const std::vector<NumberedFace> faces = random_faces(random, 2000, {0, 0, 0}, 0.1);
  test::TestJob test;
  const SurfaceTree tree(test.job, faces);
  for (int round = 0; round < 300; ++round) {
    const Point point = random_point(random, 1.5);
    const double enough = random.real(0, 0.3);
    const NearestFace right = by_looking_at_all(faces, point);
    NearestFace found;
    tree.search(point, found, enough * enough);
    if (right.squared < enough * enough) {
      CHECK(found.squared < enough * enough);
    } else {
      CHECK(found.squared == right.squared);
    }
  }
}

TEST_CASE("beginning with the face found last changes nothing of what is found") {
  test::Random random(713);
  const std::vector<NumberedFace> faces = random_faces(random, 2000, {0, 0, 0}, 0.1);
  test::TestJob test;
  const SurfaceTree tree(test.job, faces);
  NeighbourSearch neighbours(tree);
  Point point = random_point(random, 1.5);
  for (int round = 0; round < 1000; ++round) {
    // Some are no nearer than what is already known of their point, and must not be found.
    point = random.chance(0.1) ? random_point(random, 1.5) : point + random_point(random, 0.01);
    const double known = random.chance(0.5) ? NearestFace{}.squared : random.real(0, 0.01);
    NearestFace right{known, 0};
    const bool nearer = tree.search(point, right);
    NearestFace found{known, 0};
    CHECK(neighbours.search(point, found) == nearer);
    CHECK(found.squared == right.squared);
    CHECK(found.number == right.number);
    CHECK(found.face == right.face);
  }
}

TEST_CASE("a tree keeps to the memory it reserves") {
  test::Random random(712);
  test::TestJob test;
  const std::vector<NumberedFace> faces = random_faces(random, 400'000, {0, 0, 0}, 0.01);
  const std::uint64_t before = peak_resident_bytes();
  const SurfaceTree tree(test.job, faces);
  CHECK(test.job.budget.used() == faces.size() * SurfaceTree::bytes_a_face);
  CHECK(peak_resident_bytes() - before <
        faces.size() * SurfaceTree::bytes_a_face + (std::uint64_t{16} << 20));
}

TEST_CASE("a tree of nothing finds nothing") {
  test::TestJob test;
  const SurfaceTree tree(test.job, {});
  NearestFace found;
  CHECK_FALSE(tree.search({0, 0, 0}, found));
}

}  // namespace winnow
