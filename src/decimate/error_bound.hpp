// What --error promises, watched while edges are collapsed: how far the surface may come from all
// that was collapsed into it, and how far its boundary from the boundary that was.
//
// - The mean squared distance of a vertex from the planes of all faces that it stands for, weighted
//   by their areas, is at most the square of the error (the quadrics of Garland and Heckbert 1997,
//   never forgotten).
// - The farthest point that a vertex remembers (witness_points.hpp) is within one and a half times
//   the error.
// - A piece of the surface goes only if the box of all its vertices that there were is smaller than
//   the error, on each axis.
// - Handles and boundaries close, where they may, if what closes is smaller likewise.
// - A boundary is within one and a half times the error of what it was, both ways: each edge of it
//   has the sum of the distances by which the boundary around it has moved, which by the triangle
//   inequality is no less.
#pragma once

#include "base/box.hpp"
#include "base/quadric.hpp"
#include "decimate/edge_star.hpp"
#include "decimate/legality.hpp"
#include "decimate/piece.hpp"
#include "decimate/tile_mesh.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

class ErrorBound {
 public:
  // What a vertex remembers between two rounds.
  struct State {
    Quadric planes;           // seen from it
    double boundary_off = 0;  // of the boundary's edges that begin there
    // The box of all vertices that it stands for, seen from it and rounded outwards.
    std::array<float, 3> low{}, high{};
  };

  // `states`: of each vertex. `at_boundary`: of each vertex whether it may be at one; kept up to
  // date by the owner.
  ErrorBound(TileMesh& mesh, double error, std::vector<State> states,
             const std::vector<std::uint8_t>& at_boundary)
      : mesh_(mesh), error_(error), state_(std::move(states)), at_boundary_(at_boundary) {}

  static constexpr std::uint64_t memory(std::uint64_t vertices) { return vertices * sizeof(State); }

  // Adds to `states` the planes of all faces, each with a third of its area.
  static void add_faces(const TileMesh& mesh, const CoordinateRounding& rounding,
                        std::vector<State>& states);
  // Adds the lines of all edges with one face.
  static void add_boundaries(TileMesh& mesh, std::vector<State>& states);

  // Of the collapse of this edge, whose star this is. `change`: what it changes, or null.
  [[nodiscard]] bool allows(const Collapse& edge, const EdgeStar& star,
                            const SurfaceChange* change = nullptr);

  // Whether the surface may change so.
  [[nodiscard]] bool allows(const EdgeStar& star, const SurfaceChange& change) const;

  // Whether the piece may go.
  [[nodiscard]] bool allows(const Piece& piece) const;

  // To be told of the collapse that allows() was asked about last: before it is done.
  void collapsing(const Collapse& edge);

  // The least errors that allow the edge that allows() was asked about last, and these.
  [[nodiscard]] double needed() const;
  [[nodiscard]] double needed(const EdgeStar& star, const SurfaceChange& change) const;
  [[nodiscard]] double needed(const Piece& piece) const { return above(size_of(piece.vertices)); }

  // The least error where the farthest point that a vertex remembers is so far.
  static double needed_by(double farthest) { return farthest / farthest_share; }
  // How far the farthest point that a vertex remembers may be.
  [[nodiscard]] double farthest() const { return farthest_share * error_; }
  [[nodiscard]] const State& state(VertexNumber v) const { return state_[v]; }
  // The root of the mean squared distance of a vertex from its planes, the largest there was.
  [[nodiscard]] double largest_error() const;

 private:
  static constexpr double farthest_share = 1.5;
  using Segment = std::array<Point, 2>;
  void add_box(VertexNumber v, Box& box) const;
  // The longest side of the box of all that these stand for.
  [[nodiscard]] double size_of(std::span<const VertexNumber> vertices) const;
  // The least number that this is smaller than.
  static double above(double size);
  // The longest side of all that closes; infinite where nothing may.
  [[nodiscard]] double size_of(const EdgeStar& star, const SurfaceChange& change) const;
  // How far the boundary has moved then, all together; infinite where it would go.
  double boundary_moved(const Collapse& edge, const EdgeStar& star, const SurfaceChange* change);

  TileMesh& mesh_;
  double error_;
  std::vector<State> state_;
  const std::vector<std::uint8_t>& at_boundary_;
  double largest_square_ = 0;
  // Of the collapse that was asked about last.
  Quadric planes_;
  double boundary_off_ = 0;
  std::vector<VertexNumber> boundary_starts_;  // of its edges afterwards
  std::vector<Segment> before_, after_;
};

}  // namespace winnow
