// What a progressive file shows, as a mesh that can be written.
#pragma once

#include "cluster/grid.hpp"
#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"
#include "progressive/split_player.hpp"
#include "run/output_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <optional>
#include <vector>

namespace winnow {

// Vertices that have a face, in the order of their keys, and faces in the order of their lowest
// vertices. The player has to stay where it is.
class PlayedMesh final : public OutputMesh {
 public:
  // `carried`: which of the file's attributes vertices have. `normals`: whether they have those of
  // their faces. `scratch`: where they are ordered, or null: in memory.
  PlayedMesh(Job& job, const SplitPlayer& player, std::vector<std::size_t> carried, bool normals,
             ScratchMemory* scratch);

  // What it takes, without stored().
  static std::uint64_t memory(std::uint64_t vertices, bool normals);

  [[nodiscard]] std::uint64_t vertex_count() const override { return order_.size(); }
  [[nodiscard]] std::uint64_t face_count() const override { return mesh_.faces(); }
  [[nodiscard]] Box box(Job& job) const override;
  [[nodiscard]] FinishedVertices vertices(const MeshShape& shape, std::uint64_t first,
                                          std::size_t count) const override;
  [[nodiscard]] std::unique_ptr<FaceStream> faces() const override;
  // Made when it is asked for first.
  [[nodiscard]] const StoredMesh& stored() const override;

  // A copy that lasts.
  [[nodiscard]] StoredMesh store() const;

 private:
  class Faces;
  // A vertex behind the high bits of its key.
  using Ranked = std::uint64_t;

  [[nodiscard]] std::uint32_t vertex(std::size_t place) const {
    return static_cast<std::uint32_t>(order_[place]);
  }
  [[nodiscard]] Point position(std::uint32_t v) const {
    return player_.words().position(mesh_.words(v));
  }
  [[nodiscard]] CellKey key(std::uint32_t v) const;
  [[nodiscard]] IndexedVertex indexed(std::size_t place) const;
  void take_values(std::size_t place, std::span<double> means, std::span<double> values) const;
  [[nodiscard]] std::pmr::memory_resource* pool() const;
  void turn() const;
  void order_vertices();
  void order_alike();
  void sum_normals();

  Job& job_;
  const SplitPlayer& player_;
  const SplitMesh& mesh_;
  const std::vector<std::size_t> carried_;
  ScratchMemory* const scratch_;
  Reservation reserved_;
  Grid lattice_;
  std::pmr::vector<Ranked> order_;
  std::pmr::vector<std::uint32_t> number_;  // of each vertex in the order
  std::pmr::vector<Point> normal_;          // of each vertex, where they have some
  mutable std::optional<StoredMesh> stored_;
};

}  // namespace winnow
