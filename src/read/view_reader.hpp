// A mesh in arrays of the caller, read where it is.
#pragma once

#include <winnow/mesh.hpp>

#include "read/mesh_reader.hpp"

#include <memory>

namespace winnow {

// Of a mesh that was checked (view_arrays.hpp), whose arrays outlive the reader; as open_reader()
// and probe_input().
std::unique_ptr<MeshReader> open_view(Job& job, const MeshView& mesh, const ReaderMemory& memory,
                                      const AttributeRequest& wish);
InputProbe look_at_view(const MeshView& mesh, const AttributeRequest& wish);

}  // namespace winnow
