#include "python/sequences.hpp"

#include "python/arrays.hpp"

#include <utility>

namespace winnow::python {

namespace py = pybind11;

ArrayFrames::ArrayFrames(const std::vector<py::array>& points, const py::array& faces)
    : faces_(rows_of(faces)) {
  for (const py::array& frame : points) points_.push_back(rows_of(frame));
}

bool ArrayFrames::next(MeshView& frame) {
  if (at_ == points_.size()) return false;
  frame.positions = points_[at_++];
  frame.faces = faces_;
  return true;
}

void KeptFrames::take(std::uint64_t /*frame*/, Mesh mesh) {
  frames_.push_back(std::move(mesh));
}

py::list KeptFrames::arrays() && {
  py::list all;
  std::vector<std::uint32_t> before;
  for (Mesh& frame : frames_) {
    const bool same = !all.empty() && frame.faces == before;
    if (!same) before = frame.faces;
    const py::tuple arrays = arrays_of(std::exchange(frame, {}));
    all.append(py::make_tuple(arrays[0], same ? py::object(py::none()) : py::object(arrays[1])));
  }
  return all;
}

}  // namespace winnow::python
