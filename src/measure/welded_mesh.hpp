// A mesh in memory whose vertices are places: what stands in the same place is one.
#pragma once

#include <winnow/compare.hpp>

#include "io/job.hpp"
#include "measure/surface_tree.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace winnow {

class WeldedMesh {
 public:
  // Memory of a mesh of so many faces with at most as many vertices, while it is made and its
  // topology counted; one with more takes more of the budget.
  static constexpr std::uint64_t bytes_a_place = 24 + 12;
  static constexpr std::uint64_t bytes_a_face = bytes_a_place + 12 + 24;

  WeldedMesh(Job& job, std::span<const NumberedFace> faces);

  // Gives back what only making it and topology() took.
  void seal() { making_.release(); }
  static constexpr std::uint64_t bytes_a_sealed_face = 24 + 12;

  [[nodiscard]] std::uint64_t more_bytes() const { return more_.bytes(); }  // beyond bytes_a_face

  [[nodiscard]] const std::vector<Point>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<std::array<std::uint32_t, 3>>& faces() const { return faces_; }

  // Everything but `flipped`, for which the original is needed.
  [[nodiscard]] CompareReport::Topology topology() const;
  [[nodiscard]] CompareReport::Angles smallest_angles() const;

 private:
  [[nodiscard]] bool has_area(const std::array<std::uint32_t, 3>& face) const;
  void count_edges(CompareReport::Topology& topology) const;
  void count_duplicates(CompareReport::Topology& topology) const;
  void count_components(CompareReport::Topology& topology) const;

  Job& job_;
  Reservation reservation_, making_, more_;
  std::vector<Point> vertices_;
  std::vector<std::array<std::uint32_t, 3>> faces_;  // in the order given
};

}  // namespace winnow
