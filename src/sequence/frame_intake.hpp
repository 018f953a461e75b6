// Reads the frames of a sequence, and makes one mesh of them: the connectivity and the first frame
// are the mesh, the positions in the other frames are the state of its vertices
// (decimate/frames.hpp).
#pragma once

#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"
#include "read/mesh_reader.hpp"
#include "sequence/frame_attributes.hpp"
#include "sequence/frame_readers.hpp"
#include "sequence/original_frames.hpp"
#include "sequence/vertex_order.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace winnow {

// Most of what each part may use of the budget.
struct IntakeMemory {
  ReaderMemory reader;
  std::uint64_t arrays = 0;  // one frame, and numbers of its vertices: has to be enough
  std::uint64_t frames = 0;  // all of them
  std::uint64_t mesh = 0;    // what comes out
  std::uint64_t sorting = 0;

  // Bytes of arrays for so many vertices, which carry so many numbers.
  static constexpr std::uint64_t arrays_for(std::uint64_t vertices, std::size_t numbers) {
    return vertices * (sizeof(Point) + 2 * sizeof(std::uint64_t) + 4 * sizeof(std::uint32_t) + 2 +
                       2 * numbers * sizeof(double));
  }
};

struct SequenceMesh {
  StoredMesh mesh;
  OriginalFrames original;
  std::size_t frames = 0;
  std::string format;                     // of the first frame
  std::uint64_t vertices = 0, faces = 0;  // of one frame, as they were read
  std::uint64_t bytes = 0;
  std::uint64_t joined = 0, bad_faces = 0;
  std::vector<Attribute> attributes;  // that vertices carry in each frame, the first one's first
  AttributeSelection dropped;         // of the first frame, and what not all have
  bool normals = false;               // the first frame has some
  bool double_positions = false;      // some frame has
};

// Throws Error(bad_input) where frames differ in their vertices or faces, naming both and the first
// difference; Error(resources), with arrays that are enough for the first frame by way of
// `refuse`, where those are too small.
class FrameIntake {
 public:
  FrameIntake(Job& job, FrameReaders& readers, const IntakeMemory& memory);

  // Once. `refuse`: throws, for a frame of so many vertices that needs so many bytes.
  using Refuse = std::function<void(std::uint64_t vertices, std::uint64_t bytes)>;
  SequenceMesh run(const Refuse& refuse, const FrameAttributes::Settle& settle);

 private:
  void add_first(MeshReader& reader);
  void add_later(MeshReader& reader);
  void read_positions(MeshReader& reader);
  void read_corners(MeshReader& reader);
  void take_room(std::uint64_t vertices);
  void read_faces(MeshReader& reader, Spool& into);
  void compare_faces(MeshReader& reader);
  void order_vertices();
  void keep_frame();
  void join_vertices();
  void number_used(const Spool& faces);
  [[noreturn]] void refuse_counts(const char* what, std::uint64_t here, std::uint64_t first) const;
  void write_vertices(StoredMesh& mesh);
  void write_faces(StoredMesh& mesh, const Spool& faces);

  Job& job_;
  FrameReaders& readers_;
  IntakeMemory memory_;
  const Refuse* refuse_ = nullptr;
  const FrameAttributes::Settle* settle_ = nullptr;
  FrameAttributes carried_;
  SequenceMesh out_;
  bool corners_ = false;  // of faces are all vertices that there are
  Reservation arrays_;
  std::vector<Point> position_;         // of one frame, as it is read; then in key order
  VertexOrder order_;                   // from the first frame on, that of all arrays
  std::vector<std::uint64_t> path_;     // a hash of where each of them is in all frames so far
  std::vector<std::uint32_t> same_as_;  // the first at the same places, by key order
  std::vector<std::uint32_t> number_;   // in the mesh, by key order; no_number for those not in it
  std::vector<std::uint8_t> finite_;    // in all frames, by key order
  std::unique_ptr<Spool> frames_;       // positions in key order, frame after frame
  Spool raw_faces_;                     // polygons as fans, to be compared with
  Spool cut_faces_;                     // of polygons
  bool polygons_ = false;
};

}  // namespace winnow
