// The vertices of a PLY: looked up in the file where that can be mapped, else kept.
#pragma once

#include "io/byte_source.hpp"
#include "io/job.hpp"
#include "read/indexed/vertex_store.hpp"
#include "read/mesh_reader.hpp"
#include "read/ply/header.hpp"
#include "read/ply/values.hpp"

namespace winnow {

class PlyVertices {
 public:
  // Of the facts: what positions are, and which attributes are chosen.
  PlyVertices(Job& job, ByteSource& source, PlyValues& values, PlyForm form,
              const InputFacts& facts)
      : job_(job), source_(source), values_(values), form_(form), facts_(facts) {}

  // Fills `vertices` with the element, at whose beginning the source stands, and passes over it.
  // Throws Error(bad_input) where it has no positions, more than indices count to, or was cut
  // short.
  void read(const PlyElement& element, VertexStore& vertices);

 private:
  // By number among the vertices' numbers other than coordinates.
  [[nodiscard]] bool carries(std::size_t scalar) const;
  [[nodiscard]] VertexLayout layout_of(const PlyElement& element) const;
  void keep_fixed(const PlyElement& element, const VertexLayout& layout, VertexStore& vertices);
  void keep_values(const PlyElement& element, VertexStore& vertices);

  Job& job_;
  ByteSource& source_;
  PlyValues& values_;
  PlyForm form_;
  const InputFacts& facts_;
};

}  // namespace winnow
