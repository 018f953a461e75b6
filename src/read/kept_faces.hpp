// Triangles that wait for their vertices, in memory or scratch.
#pragma once

#include "io/spool.hpp"
#include "read/mesh_reader.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace winnow {

// Filled once, by one thread; then read any number of times.
class KeptFaces {
 public:
  static constexpr std::uint64_t bytes_a_face = 12;

  KeptFaces(Job& job, std::uint64_t memory_limit) : spool_(job, memory_limit) {}

  // How a face of fewer than three corners is kept: numbers that no three vertices of one face have. The
  // first is of none, see MeshReader's indices.
  static constexpr std::array<std::uint32_t, 3> degenerate{UINT32_MAX, UINT32_MAX - 1, UINT32_MAX - 2};
  // What is kept of a face; one that names these very numbers, of vertices that there are not, gets others.
  static std::array<std::uint32_t, 3> kept(const RawBatch& batch, std::size_t face);
  // The status of faces whose indices were kept.
  static void restore_status(RawBatch& batch);

  // Three indices a face, which need not be those of vertices.
  void add(std::span<const std::uint32_t> indices) { spool_.append(std::as_bytes(indices)); }
  void add_degenerate();            // fewer than three corners
  void add(const RawBatch& batch);  // of indices
  void finish() { spool_.finish(); }

  [[nodiscard]] std::uint64_t size() const { return spool_.size() / bytes_a_face; }

  // The next faces from `first` on, at most `most`, as indices, status and count of `batch`.
  void read(std::uint64_t first, std::size_t most, RawBatch& batch) const;

 private:
  Spool spool_;
};

}  // namespace winnow
