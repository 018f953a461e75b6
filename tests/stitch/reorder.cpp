// Another order of the vertices is the same surface, and there and back is where it began.
#include "stitch/reorder.hpp"

#include "support/refining.hpp"

#include <algorithm>
#include <cstring>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// By positions, each from its least corner on: what a surface is, whatever its numbers are.
std::vector<Triangle> surface_of(const PlainMesh& mesh) {
  std::vector<Triangle> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    Triangle face = mesh.triangle(f);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

// A state for each vertex that says which it is.
std::unique_ptr<Spool> states_of(Job& job, const PlainMesh& mesh) {
  auto spool = std::make_unique<Spool>(job, std::uint64_t{1} << 24);
  for (const IndexedVertex& vertex : mesh.vertices)
    spool->append(std::as_bytes(std::span(&vertex.position, 1)));
  spool->finish();
  return spool;
}

void check_states(const StoredMesh& whole, const PlainMesh& mesh) {
  REQUIRE(whole.state->size() == mesh.vertices.size() * sizeof(Point));
  std::vector<Point> states(mesh.vertices.size());
  whole.state->read(0, std::as_writable_bytes(std::span(states)));
  std::uint64_t wrong = 0;
  for (std::size_t v = 0; v < states.size(); ++v) wrong += states[v] != mesh.vertices[v].position;
  CHECK(wrong == 0);
}

// The same as two attributes: a coordinate and its square.
std::unique_ptr<Spool> attributes_of(Job& job, const PlainMesh& mesh) {
  auto spool = std::make_unique<Spool>(job, std::uint64_t{1} << 24);
  for (const IndexedVertex& vertex : mesh.vertices) {
    const std::array<double, 2> values{vertex.position[0], vertex.position[0] * vertex.position[0]};
    spool->append(std::as_bytes(std::span(values)));
  }
  spool->finish();
  return spool;
}

void check_attributes(const StoredMesh& whole, const PlainMesh& mesh) {
  std::vector<std::array<double, 2>> values(mesh.vertices.size());
  REQUIRE(whole.attributes->size() == values.size() * sizeof(values[0]));
  whole.attributes->read(0, std::as_writable_bytes(std::span(values)));
  std::uint64_t wrong = 0;
  for (std::size_t v = 0; v < values.size(); ++v) {
    const double x = mesh.vertices[v].position[0];
    wrong += values[v] != std::array{x, x * x};
  }
  CHECK(wrong == 0);
}

void check_order(const PlainMesh& mesh) {
  CHECK(std::is_sorted(mesh.vertices.begin(), mesh.vertices.end(),
                       [](const auto& a, const auto& b) { return a.key < b.key; }));
  CHECK(std::is_sorted(mesh.faces.begin(), mesh.faces.end()));
  for (const auto& face : mesh.faces) REQUIRE(face[0] < std::min(face[1], face[2]));
}

}  // namespace

TEST_CASE("a mesh in the order of a shifted lattice is the same surface") {
  for (const std::string& path : {whale(), mountains()}) {
    // In memory, and through scratch.
    for (const std::uint64_t memory : {std::uint64_t{64} << 20, std::uint64_t{1} << 18}) {
      CAPTURE(path, memory);
      TestJob test;
      StoredMesh whole = welded(test.job, path);
      PlainMesh before = plain(whole);
      whole.layout = {sizeof(Point), 2};
      whole.state = states_of(test.job, before);
      whole.attributes = attributes_of(test.job, before);

      StoredMesh there = reorder(test.job, std::move(whole), false, memory, memory);
      const PlainMesh shifted = plain(there);
      check_order(shifted);
      check_states(there, shifted);
      check_attributes(there, shifted);
      CHECK((surface_of(shifted) == surface_of(before)));
      // Other tiles have other borders: hardly a vertex keeps its number.
      std::uint64_t same = 0;
      for (std::size_t v = 0; v < before.vertices.size(); ++v)
        same += shifted.vertices[v].position == before.vertices[v].position;
      CHECK(same < before.vertices.size() / 10);

      const StoredMesh back = reorder(test.job, std::move(there), true, memory, memory);
      // Only faces of one lowest vertex had another order.
      std::sort(before.faces.begin(), before.faces.end());
      CHECK(difference(plain(back), before) == "");
      check_states(back, before);
      check_attributes(back, before);
    }
  }
}

}  // namespace winnow
