// What an edge costs in a sequence: the sum over frames, and both weights.
#include "decimate/piece.hpp"
#include "decimate/quadric_cost.hpp"
#include "decimate/sequence_cost.hpp"
#include "decimate/witness_points.hpp"
#include "support/moving_sheet.hpp"

#include <algorithm>
#include <cstring>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

using FramePositions = std::vector<Point>;

TileMesh mesh_of(const FramePositions& positions, const std::vector<FaceVertices>& faces) {
  return {positions, faces, std::vector<std::uint8_t>(positions.size(), 0)};
}

FramePositions scaled(FramePositions positions, double by) {
  for (Point& p : positions) p = by * p;
  return positions;
}

// Where vertices are in all frames but the first.
std::vector<std::byte> state_of(const std::vector<FramePositions>& frames) {
  std::vector<std::byte> state;
  for (std::size_t v = 0; v < frames.front().size(); ++v) {
    for (std::size_t t = 1; t < frames.size(); ++t) {
      const auto bytes = std::as_bytes(std::span(&frames[t][v], 1));
      state.insert(state.end(), bytes.begin(), bytes.end());
    }
  }
  return state;
}

// Cost of an edge in frames of one connectivity.
double cost_of(const std::vector<FramePositions>& frames, const std::vector<FaceVertices>& faces,
               VertexNumber a, VertexNumber b, double deformation, double feature,
               bool accumulated = false) {
  TileMesh mesh = mesh_of(frames.front(), faces);
  const std::vector<std::byte> state = state_of(frames);
  DecimationSettings settings;
  settings.single = false;
  settings.sequence = {frames.size(), deformation, feature};
  settings.sequence->accumulated = accumulated;
  Frames of(mesh, state, Frames::saved_size(frames.size()), frames.size());
  SequenceCost cost(mesh, of, state, settings);
  return cost.place(a, b).cost;
}

double cost_alone(const FramePositions& frame, const std::vector<FaceVertices>& faces,
                  VertexNumber a, VertexNumber b) {
  TileMesh mesh = mesh_of(frame, faces);
  QuadricCost cost(mesh, false, coordinate_rounding(false));
  return cost.place(a, b).cost;
}

// The cost of an edge grows with the fourth power of the size: an area times a squared distance.
const FramePositions octahedron{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
const std::vector<FaceVertices> octahedron_faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                 {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

}  // namespace

TEST_CASE("one frame costs what it costs alone") {
  const test::MovingSheet sheet{6};
  const FramePositions frame = sheet.positions(3);
  const std::vector<FaceVertices> faces = sheet.faces();
  for (const VertexNumber v : {0U, 8U, 24U, 47U})
    CHECK(cost_of({frame}, faces, v, v + 1, 1, 0) == cost_alone(frame, faces, v, v + 1));
}

TEST_CASE("more frames than a batch holds cost the sum of what each costs alone") {
  const test::MovingSheet sheet{6};
  const std::vector<FaceVertices> faces = sheet.faces();
  std::vector<FramePositions> frames;
  double sum = 0;
  for (std::size_t t = 0; t < 37; ++t) {
    frames.push_back(sheet.positions(t));
    sum += cost_alone(frames.back(), faces, 16, 17);
  }
  CHECK(cost_of(frames, faces, 16, 17, 0, 0) == Approx(sum).epsilon(1e-12));
}

TEST_CASE("a piece costs in each frame what a point does that is off by 1.2 times its size") {
  const auto cost_of_piece = [](const std::vector<FramePositions>& frames) {
    TileMesh mesh = mesh_of(frames.front(), octahedron_faces);
    const std::vector<std::byte> state = state_of(frames);
    DecimationSettings settings;
    settings.single = false;
    settings.sequence = {frames.size(), 0, 0};
    Frames of(mesh, state, Frames::saved_size(frames.size()), frames.size());
    SequenceCost cost(mesh, of, state, settings);
    Piece piece;
    REQUIRE(piece.find(mesh, 0, [](VertexNumber) { return false; }));
    return cost.cost_of_piece(mesh, piece);
  };
  // Every vertex is one away from the middle.
  const double still = cost_of_piece({octahedron});
  CHECK(still == Approx(WitnessPoints::cost_of(1.2 * 1.2)));
  CHECK(cost_of_piece({octahedron, scaled(octahedron, 2)}) == Approx(17 * still));
}

TEST_CASE("before the first collapse, quadrics that remember cost the same") {
  const std::vector<FramePositions> frames{octahedron, scaled(octahedron, 2)};
  const double now = cost_of(frames, octahedron_faces, 0, 2, 0, 0);
  CHECK(cost_of(frames, octahedron_faces, 0, 2, 0, 0, true) == Approx(now).epsilon(1e-9));
  CHECK(cost_of(frames, octahedron_faces, 0, 2, 1, 0, true) == Approx(32.0 / 17 * now));
}

TEST_CASE("quadrics that remember keep the planes of all that was collapsed") {
  TileMesh mesh = mesh_of(octahedron, octahedron_faces);
  DecimationSettings settings;
  settings.single = false;
  settings.sequence = {1, 0, 0, true};
  Frames frames(mesh, {}, 0, 1);
  const auto quadrics = make_frame_quadrics(mesh, frames, {}, settings);
  // All planes are off from the middle by the root of 1/3. Each corner of the four faces at a
  // vertex has a third of an area of half the root of 3.
  const double of_vertex = 4 * (std::sqrt(3) / 6) / 3;
  const Point middle{};
  CHECK(quadrics->cost_at(0, 4, 0, middle) == Approx(2 * of_vertex));
  EdgeInFrames edge(1);
  quadrics->evaluate(0, 2, edge);
  EdgeStar star(coordinate_rounding(false));
  star.find(mesh, 0, 2);
  const BesideCollapse beside(mesh);
  const Collapse collapse{0, 2, edge.to.front()};
  quadrics->collapsing(collapse, star, edge, beside);
  mesh.collapse(collapse);
  frames.move(0, edge.to);
  quadrics->collapsed(collapse, beside);
  CHECK(quadrics->cost_at(0, 4, 0, middle) == Approx(3 * of_vertex));
}

TEST_CASE("the deformation weight adds the deviations from the mean cost") {
  const double one = cost_alone(octahedron, octahedron_faces, 0, 2);
  REQUIRE(one > 0);
  // Twice as large, the octahedron's edge costs 16 times as much. The mean of 1 and 16 is 8.5, so
  // the deviations are 7.5 and 7.5.
  const std::vector<FramePositions> frames{octahedron, scaled(octahedron, 2)};
  CHECK(cost_of(frames, octahedron_faces, 0, 2, 0, 0) == Approx(17 * one));
  CHECK(cost_of(frames, octahedron_faces, 0, 2, 1, 0) == Approx(32 * one));
  CHECK(cost_of(frames, octahedron_faces, 0, 2, 3, 0) == Approx(62 * one));
  // Of a rigid motion nothing is added.
  CHECK(cost_of({octahedron, octahedron, octahedron}, octahedron_faces, 0, 2, 5, 0) ==
        Approx(3 * one));
}

TEST_CASE("the feature weight is the mean of the first and the last frame's") {
  // A needle: an octahedron so flat along one axis that the faces at its rim meet at less than 60
  // degrees.
  FramePositions flat = octahedron;
  flat[4][2] = 0.2;
  flat[5][2] = -0.2;
  // Unit normals of two faces at the rim are (a, a, +-5a) with 27 a^2 = 1: their angle has the
  // cosine (2 - 25) / 27, and the faces meet at an angle with the cosine 23 / 27.
  const double weight = std::sqrt(1 - 23.0 / 27 * 23 / 27);
  const double of_flat = cost_alone(flat, octahedron_faces, 0, 2);
  const double of_round = cost_alone(octahedron, octahedron_faces, 0, 2);
  CHECK(cost_of({flat, flat}, octahedron_faces, 0, 2, 0, 0.5) ==
        Approx(2 * of_flat * (1 + 0.5 * weight)));
  CHECK(cost_of({flat, octahedron}, octahedron_faces, 0, 2, 0, 0.5) ==
        Approx((of_flat + of_round) * (1 + 0.5 * weight / 2)));
  // What lies between them does not count.
  CHECK(cost_of({octahedron, flat, octahedron}, octahedron_faces, 0, 2, 0, 0.5) ==
        Approx(of_flat + 2 * of_round));
}

}  // namespace winnow
