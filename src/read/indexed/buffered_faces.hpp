// Triangles that wait for their vertices, in memory or scratch.
#pragma once

#include "base/memory_shares.hpp"
#include "io/spool.hpp"
#include "read/mesh_reader.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace winnow {

// Filled once, by one thread; then read any number of times.
class BufferedFaces {
 public:
  using Grow = RawBatch::Grow;
  static constexpr std::uint64_t bytes_a_face = 12;

  BufferedFaces(Job& job, std::uint64_t memory_limit)
      : spool_(job, memory_limit), fans_(job, share::reading::fans(memory_limit)) {}

  // How a face of fewer than three corners is kept: numbers that no three vertices of one face
  // have. The first is of none, see MeshReader's indices.
  static constexpr std::array<std::uint32_t, 3> degenerate{UINT32_MAX, UINT32_MAX - 1,
                                                           UINT32_MAX - 2};
  // What is kept of a face; one that names these very numbers, of vertices that there are not, gets
  // others.
  static std::array<std::uint32_t, 3> kept(const RawBatch& batch, std::size_t face);
  // The status of faces whose indices were kept, from one on.
  static void restore_status(RawBatch& batch, std::size_t from = 0);

  // Three indices a face, which need not be those of vertices.
  void add(std::span<const std::uint32_t> indices) { spool_.append(std::as_bytes(indices)); }
  void add_degenerate();  // fewer than three corners
  // A polygon, as a fan of triangles; of fewer than three corners, a degenerate one.
  void add_polygon(std::span<const std::uint32_t> corners);
  void add(const RawBatch& batch);  // of indices
  void finish();

  [[nodiscard]] std::uint64_t size() const { return spool_.size() / bytes_a_face; }

  // The next faces from `first` on, at most `most` unless a polygon would be cut, as indices,
  // status, fans and count of `batch`. `first` is the first triangle of a polygon. `grow` is told
  // how many come, before there is memory for them, and now and then while they are read.
  void read(std::uint64_t first, std::size_t most, RawBatch& batch, const Grow& grow = {}) const;
  // The first triangle of the polygon that has this one.
  [[nodiscard]] std::uint64_t begin_of(std::uint64_t triangle) const;

 private:
  // Polygons of so many triangles each that follow each other.
  struct Fans {
    std::uint64_t first, count, triangles;
    [[nodiscard]] std::uint64_t end() const { return first + count * triangles; }
  };
  void add_fan(std::uint64_t first, std::uint64_t triangles);
  // Of the first fans that end behind this triangle; their count where there are none.
  [[nodiscard]] std::uint64_t fans_behind(std::uint64_t triangle) const;

  Spool spool_;
  Spool fans_;
  Fans last_fans_{};  // not in the spool yet
  std::vector<std::uint32_t> fan_;
};

}  // namespace winnow
