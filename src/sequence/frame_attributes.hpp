// What the vertices of a sequence carry in each frame, while frames are read.
#pragma once

#include "base/attribute.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"
#include "read/mesh_reader.hpp"
#include "sequence/vertex_order.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// Carried are those that the first frame has. Those that a later frame lacks are dropped at the
// end; of a normal's three, all.
class FrameAttributes {
 public:
  // What all of a colour's component is, by the largest numbers of the first frame.
  using Settle = std::function<void(std::vector<Attribute>& attributes,
                                    const std::vector<MeshReader::AttributeRange>& ranges)>;

  FrameAttributes(Job& job, std::uint64_t memory) : values_(job, memory) {}

  // Before the vertices of a frame are read. `frame`: its name.
  void begin_first(MeshReader& reader, const Settle& settle);
  void begin_frame(std::uint64_t vertices);  // takes the room for one
  void begin_later(const MeshReader& reader, const std::string& frame);
  // How many numbers a vertex has in a frame while it is read.
  [[nodiscard]] std::size_t count() const { return attributes_.size(); }

  // The vertices of a view, on any thread; `place`: of each vertex, null for its own number.
  void take(const MeshReader& reader, const PositionView& view, const std::uint32_t* place);
  void put_in_order(const VertexOrder& order);
  // After the last vertex of a frame.
  void keep_frame();

  // After the last frame: what is carried, and what is not, in words.
  void finish(std::vector<std::string>& dropped);
  [[nodiscard]] const std::vector<Attribute>& carried() const { return carried_; }
  // Numbers that are not finite, in whose place is 0.
  [[nodiscard]] std::uint64_t not_finite() const { return not_finite_; }
  // Means of so many vertices from `first` on, in the frames' order, vertex by vertex.
  [[nodiscard]] std::vector<double> read(std::size_t frame, std::size_t first,
                                         std::size_t vertices) const;

 private:
  std::vector<Attribute> attributes_, carried_;
  std::vector<std::size_t> in_reader_;  // of each its number among the reader's; or none
  std::vector<std::string> lacking_;    // of each a frame without it
  std::vector<std::size_t> number_;     // of each that is carried
  std::size_t vertices_ = 0;
  std::vector<double> frame_;  // means of one frame
  Spool values_;               // frame after frame
  std::atomic<std::uint64_t> not_finite_{0};
};

}  // namespace winnow
