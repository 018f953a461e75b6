// A mesh that comes in batches, kept as the file that it would be.
#pragma once

#include <winnow/mesh.hpp>
#include <winnow/simplify.hpp>

#include "base/attribute.hpp"
#include "io/byte_source.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace winnow {

class BatchStore {
 public:
  // In what is left of the budget beside what the run needs, and in scratch beyond it.
  BatchStore(Job& job, const SimplifyOptions& options);

  // Vertices, faces or both. Throws Error: usage, bad_input, naming the array.
  void add(const MeshView& batch);
  // Positions of loose triangles, three each, with what they carry.
  void add_triangles(const MeshView& batch);

  // The last call: reads like a PLY, or like an STL where only loose triangles of floats were
  // added. Throws Error(bad_input) where no face was.
  std::unique_ptr<ByteSource> finish();

 private:
  void settle(const MeshView& batch, bool loose);
  void keep_vertices(const MeshView& batch);
  void keep_faces(const Rows<3>& faces);
  void keep_own_faces(std::uint64_t count);
  void keep_records(const Rows<3>& corners);
  [[nodiscard]] std::string head() const;

  Job& job_;
  std::unique_ptr<Spool> vertices_, faces_;
  std::uint64_t vertex_count_ = 0, face_count_ = 0;
  std::optional<bool> loose_;
  std::optional<bool> doubles_;
  std::optional<std::vector<Attribute>> attributes_;
};

}  // namespace winnow
