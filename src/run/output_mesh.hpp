// A mesh on its way out.
#pragma once

#include "base/box.hpp"
#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"
#include "write/mesh_encoder.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace winnow {

// Vertices as they are written, with what they carry.
struct FinishedVertices {
  std::vector<MeshVertex> vertices;
  std::vector<double> attributes;  // that they point to
};

// Faces one after the other.
class FaceStream {
 public:
  virtual ~FaceStream() = default;

  // The numbers of the corners of the next ones, up to as many as this; fewer only at the end.
  [[nodiscard]] virtual std::vector<std::uint32_t> next(std::size_t count) = 0;
};

class OutputMesh {
 public:
  virtual ~OutputMesh() = default;

  [[nodiscard]] virtual std::uint64_t vertex_count() const = 0;
  [[nodiscard]] virtual std::uint64_t face_count() const = 0;
  [[nodiscard]] virtual Box box(Job& job) const = 0;

  // Asked by several threads.
  [[nodiscard]] virtual FinishedVertices vertices(const MeshShape& shape, std::uint64_t first,
                                                  std::size_t count) const = 0;
  // The mesh has to stay.
  [[nodiscard]] virtual std::unique_ptr<FaceStream> faces() const = 0;
  // For who needs more of it. Asked by one thread.
  [[nodiscard]] virtual const StoredMesh& stored() const = 0;
};

// The mesh has to stay.
class StoredOutput final : public OutputMesh {
 public:
  explicit StoredOutput(const StoredMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] std::uint64_t vertex_count() const override { return mesh_.vertices->size(); }
  [[nodiscard]] std::uint64_t face_count() const override { return mesh_.face_count; }
  [[nodiscard]] Box box(Job& job) const override;
  [[nodiscard]] FinishedVertices vertices(const MeshShape& shape, std::uint64_t first,
                                          std::size_t count) const override;
  [[nodiscard]] std::unique_ptr<FaceStream> faces() const override;
  [[nodiscard]] const StoredMesh& stored() const override { return mesh_; }

 private:
  const StoredMesh& mesh_;
};

}  // namespace winnow
