// Sequences as arrays of numpy.
#pragma once

#include <winnow/sequence.hpp>

#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace winnow::python {

// Frames with the same faces; see rows_of() for the arrays, which must outlive this.
class ArrayFrames final : public FrameSource {
 public:
  ArrayFrames(const std::vector<pybind11::array>& points, const pybind11::array& faces);

  bool next(MeshView& frame) override;

 private:
  std::vector<Rows<3>> points_;
  Rows<3> faces_;
  std::size_t at_ = 0;
};

class KeptFrames final : public FrameSink {
 public:
  void take(std::uint64_t frame, Mesh mesh) override;

  // A list of (points, faces) for each; of all but the first, faces are None where they are those
  // of the frame before.
  pybind11::list arrays() &&;

 private:
  std::vector<Mesh> frames_;
};

}  // namespace winnow::python
