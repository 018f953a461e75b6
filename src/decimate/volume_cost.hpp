// The volume between a vertex and its neighbours: the cost of Guha ("Mesh simplification via a volume cost
// measure"). A vertex is removed into a neighbour, which stays where it is.
#pragma once

#include "decimate/collapser.hpp"
#include "decimate/fan.hpp"
#include "decimate/running_median.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace winnow {

// What removing the vertex of a fan would take away.
struct CoveredVolume {
  double angle = 0;
  double height = 0;
  [[nodiscard]] double volume() const { return angle * height * height * height; }
};

// Nothing where the vertex is hyperbolic.
std::optional<CoveredVolume> covered_volume(std::span<const Point> seen, bool closed);

class VolumeCost {
 public:
  explicit VolumeCost(TileMesh& mesh);

  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    return vertices * sizeof(double) + RunningMedian::memory(vertices);
  }

  [[nodiscard]] Candidate best(VertexNumber v, const Candidate& after);
  [[nodiscard]] PricedCollapse place(VertexNumber v, VertexNumber partner) const;
  void collapsing(const PricedCollapse& now);
  void collapsed(const Collapse& edge, Offers& offers);
  void gave_up(VertexNumber v, Offers& offers);

  [[nodiscard]] static double largest_error() { return 0; }  // not a distance

 private:
  void measure(VertexNumber v);
  void leave_out(VertexNumber v);
  void offer_anew(Offers& offers);

  TileMesh& mesh_;
  // Of all vertices that could go. Those in the upper half compete.
  RunningMedian angles_;
  // Of each vertex the largest so far, its own or one that went beside it: it never falls. Otherwise a part
  // goes vertex by vertex, each of them next to nothing.
  std::vector<double> volume_;
  Fan fan_;
  std::vector<VertexNumber> changed_;  // whose offers are to be made anew
  std::vector<VertexNumber> ring_;
};

}  // namespace winnow
