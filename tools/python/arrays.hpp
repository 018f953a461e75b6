// Meshes as arrays of numpy.
#pragma once

#include <winnow/mesh.hpp>

#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace winnow::python {

using NamedArrays = std::vector<std::pair<std::string, pybind11::array>>;

// `array` has the shape (n, 3); its numbers are native, and those of a row stand side by side. Not
// copied: it must outlive the rows.
Rows<3> rows_of(const pybind11::array& array);

// Likewise, of attributes with the shape (n).
MeshView view_of(const pybind11::array& points, const pybind11::array& faces,
                 const NamedArrays& attributes);

// Arrays that own their memory: points, faces, and a dict of attributes. The mesh is let go piece
// by piece.
pybind11::tuple arrays_of(Mesh mesh);
pybind11::array array_of(VertexMap map);

}  // namespace winnow::python
