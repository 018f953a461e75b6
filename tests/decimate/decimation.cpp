// What holds for the collapses of a whole mesh: of the whale, and of the elevation tile with its
// boundary.
#include "decimate/decimation.hpp"

#include "support/refining.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

struct Decimated {
  TileMesh mesh;
  std::vector<DoneCollapse> done;
  double largest_error = 0;
};

PlainMesh plain_mesh(const std::string& path) {
  TestJob test;
  return plain(welded(test.job, path));
}

Decimated decimated(TileMesh mesh, const DecimationSettings& settings,
                    const CollapseLimits& limits) {
  Decimated out{std::move(mesh), {}, 0};
  const auto decimation = Decimation::make(out.mesh, {}, settings);
  decimation->run(limits, [&](const DoneCollapse& done) {
    out.done.push_back(done);
    return true;
  });
  out.largest_error = decimation->largest_error();
  return out;
}

PlainMesh scaled(PlainMesh mesh, double unit) {
  for (IndexedVertex& vertex : mesh.vertices) vertex.position = unit * vertex.position;
  return mesh;
}

// Both costs: the one that forgets, and with an error the one that remembers.
std::vector<DecimationSettings> both_costs() {
  DecimationSettings forgets;
  DecimationSettings remembers;
  remembers.error = 1e300;
  return {forgets, remembers};
}

double degrees_between(const Point& a, const Point& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

}  // namespace

TEST_CASE("costs never fall, faces add up, and no face turns beyond the bound", "[long]") {
  for (const std::string& path : {whale(), mountains()}) {
    const PlainMesh plain = plain_mesh(path);
    for (DecimationSettings settings : both_costs()) {
      for (const double bound : {30.0, 80.0}) {
        settings.least_cosine = std::cos(bound / 180 * std::numbers::pi);
        const std::uint64_t wanted = plain.faces.size() / 10;
        const Decimated out = decimated(whole_tile(plain), settings,
                                        {wanted, std::numeric_limits<double>::infinity()});
        CAPTURE(path, bound, settings.error.has_value());
        CHECK(out.mesh.live_faces() <= wanted);
        CHECK(out.mesh.live_faces() + out.done.back().faces > wanted);

        // The same once more, on a mesh that knows no costs.
        TileMesh replayed = whole_tile(plain);
        double last = 0;
        double farthest = 0;
        bool thin = false;
        for (const DoneCollapse& done : out.done) {
          REQUIRE(done.cost >= last);
          last = done.cost;
          std::vector<std::pair<FaceNumber, Point>> normals;
          for (const VertexNumber end : {done.edge.kept, done.edge.removed}) {
            replayed.for_each_face(end, [&](FaceNumber f) {
              normals.emplace_back(f, doubled_area(replayed.triangle(f)));
            });
          }
          REQUIRE(replayed.collapse(done.edge) == done.faces);
          for (const auto& [f, before] : normals) {
            if (replayed.removed(f)) continue;
            const Point after = doubled_area(replayed.triangle(f));
            thin |= length(after) == 0;
            if (length(before) > 0) farthest = std::max(farthest, degrees_between(before, after));
          }
        }
        CHECK_FALSE(thin);
        CHECK(farthest <= bound + 1e-9);
        CHECK(farthest > bound / 2);  // else nothing was tested
        CHECK((live_faces(replayed) == live_faces(out.mesh)));
        const Defects before = defects_of(plain.faces);
        const Defects after = defects_of(live_faces(out.mesh));
        CHECK(after.crowded <= before.crowded);
        CHECK(after.duplicates == 0);
        CHECK(after.discords == before.discords);
        if (before.boundary_edges == 0) CHECK(after.boundary_edges == 0);
      }
    }
  }
}

TEST_CASE("the unit of length changes nothing", "[long]") {
  const PlainMesh plain = plain_mesh(whale());
  const std::uint64_t wanted = plain.faces.size() / 20;
  const CollapseLimits limits{wanted, std::numeric_limits<double>::infinity()};
  for (DecimationSettings settings : both_costs()) {
    CAPTURE(settings.error.has_value());
    const Decimated metres = decimated(whole_tile(plain), settings, limits);
    // A power of two is exact: the same collapses.
    for (const double unit : {1024.0, 1.0 / 1024}) {
      const Decimated exact = decimated(whole_tile(scaled(plain, unit)), settings, limits);
      CHECK((live_faces(exact.mesh) == live_faces(metres.mesh)));
      CHECK(exact.largest_error == unit * metres.largest_error);
    }
    // Any other rounds otherwise: as good a mesh.
    for (const double unit : {1000.0, 1e-9, 1e12}) {
      const Decimated rounded = decimated(whole_tile(scaled(plain, unit)), settings, limits);
      CHECK(rounded.mesh.live_faces() == metres.mesh.live_faces());
      CHECK(rounded.done.back().cost / (unit * unit * unit * unit) ==
            Approx(metres.done.back().cost).epsilon(0.01));
    }
  }
}

TEST_CASE("a collapse goes no costlier than its limits") {
  const PlainMesh plain = plain_mesh(mountains());
  const DecimationSettings settings;
  const Decimated all = decimated(whole_tile(plain), settings, {plain.faces.size() / 10, 1e300});
  const double middle = all.done[all.done.size() / 2].cost;
  const Decimated half = decimated(whole_tile(plain), settings, {0, middle});
  std::size_t right = 0;
  while (right < all.done.size() && all.done[right].cost <= middle) ++right;
  CHECK(half.done.size() == right);
  CHECK(half.done.back().cost <= middle);
}

TEST_CASE("with an error no vertex is farther from its planes than that, in the mean", "[long]") {
  const PlainMesh plain = plain_mesh(whale());
  DecimationSettings settings;
  std::uint64_t faces = plain.faces.size();
  for (const double share : {1e-4, 1e-3, 1e-2}) {
    Box box;
    for (const IndexedVertex& vertex : plain.vertices) box.add(vertex.position);
    settings.error = share * box.diagonal();
    const Decimated out = decimated(whole_tile(plain), settings, {0, 1e300});
    CAPTURE(share);
    CHECK(out.largest_error <= *settings.error * (1 + 1e-9));
    CHECK(out.largest_error > *settings.error / 2);
    CHECK(out.mesh.live_faces() < faces);
    faces = out.mesh.live_faces();
  }
}

TEST_CASE("locked vertices neither move nor go") {
  const PlainMesh plain = plain_mesh(whale());
  Random random(850);
  std::vector<Point> positions;
  std::vector<std::uint8_t> locked;
  for (const IndexedVertex& vertex : plain.vertices) {
    positions.push_back(vertex.position);
    locked.push_back(random.chance(0.05));
  }
  for (const DecimationSettings& settings : both_costs()) {
    const Decimated out =
        decimated(TileMesh(positions, plain.faces, locked), settings,
                  {plain.faces.size() / 3, std::numeric_limits<double>::infinity()});
    CHECK(out.mesh.live_faces() <= plain.faces.size() / 3);
    std::uint64_t wrong = 0;
    for (VertexNumber v = 0; v < locked.size(); ++v) {
      if (locked[v] != 0) wrong += !out.mesh.has_faces(v) || out.mesh.position(v) != positions[v];
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("a boundary that is kept keeps all its vertices") {
  const PlainMesh plain = plain_mesh(mountains());
  DecimationSettings settings;
  settings.keep_boundaries = true;
  const Decimated out =
      decimated(whole_tile(plain), settings,
                {plain.faces.size() / 20, std::numeric_limits<double>::infinity()});
  CHECK(defects_of(live_faces(out.mesh)).boundary_edges == defects_of(plain.faces).boundary_edges);
  CHECK(defects_of(plain.faces).boundary_edges > 500);
}

TEST_CASE("a run repeated from its list of collapses leaves the same states") {
  const PlainMesh plain = plain_mesh(whale());
  DecimationSettings settings;
  settings.error = 1e300;
  const std::size_t size = Decimation::state_size(settings);
  REQUIRE(size > 0);
  const auto states = [&](const TileMesh& mesh, const Decimation& decimation) {
    std::vector<std::byte> bytes;
    for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
      if (!mesh.has_faces(v)) continue;
      bytes.resize(bytes.size() + size);
      decimation.save(v, bytes.data() + bytes.size() - size);
    }
    return bytes;
  };
  TileMesh mesh = whole_tile(plain);
  const auto first = Decimation::make(mesh, {}, settings);
  std::vector<Collapse> edges;
  first->run({plain.faces.size() / 2, std::numeric_limits<double>::infinity()},
             [&](const DoneCollapse& done) {
               edges.push_back(done.edge);
               return true;
             });
  TileMesh again = whole_tile(plain);
  const auto second = Decimation::make(again, {}, settings);
  for (const Collapse& edge : edges) second->repeat(edge);
  CHECK((live_faces(again) == live_faces(mesh)));
  CHECK((states(again, *second) == states(mesh, *first)));
  CHECK(second->largest_error() == first->largest_error());
}

}  // namespace winnow
