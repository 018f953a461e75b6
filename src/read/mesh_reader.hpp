// A mesh file as face batches.
#pragma once

#include <winnow/simplify.hpp>

#include "io/byte_source.hpp"
#include "io/job.hpp"
#include "read/attribute_choice.hpp"
#include "read/face_batch.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// What the header tells, or, for `faces`, the size of the file.
struct InputFacts {
  std::string format;                     // for people: "PLY binary little-endian"
  std::optional<std::uint64_t> faces;     // records; a polygon may become several triangles
  std::optional<std::uint64_t> vertices;  // absent for formats without
  std::uint64_t points = 0;               // besides them, left out
  bool polygons = false;                  // of the records may be
  bool double_positions = false;
  bool mixed_positions = false;  // doubles in some of several inputs, floats in others
  bool normals = false;
  std::vector<std::string> attributes;  // "vertex: nx, ny, nz (float)"
  AvailableAttributes offer;
  AttributeSelection choice;  // those that are carried
};

// A stretch of the input, cut at whole faces (or positions) but not yet decoded.
struct RawBatch {
  // Told of how many triangles a batch is going to have, and throws if it may not.
  using Grow = std::function<void(std::uint64_t triangles)>;

  Block block;                         // bytes, or ...
  std::vector<std::uint32_t> indices;  // three a face, or ...
  std::vector<double> corners;     // nine a face: already decoded, because finding the cuts took it
  std::vector<FaceStatus> status;  // of indices and corners
  // Polygons of more than three corners among indices, which are fans so far: the first triangle of
  // each in the batch, and how many it has.
  struct Fan {
    std::uint64_t first, triangles;
  };
  std::vector<Fan> fans;
  std::uint64_t first = 0;
  std::uint64_t count = 0;             // triangles, or positions
  std::vector<std::uint32_t> numbers;  // of faces in another order than the file's: low 32 bits
  // Of indices, where CornerStreams brought them together: the vertices' records, and where those
  // of each of its parts begin.
  std::vector<std::byte> records;
  std::vector<std::uint32_t> records_begin;
};

using FaceSink = std::function<void(const FaceBatch&)>;
using PositionSink = std::function<void(const PositionView&)>;

// How the caller is going to read.
enum class Access {
  once,             // the faces, once
  positions_first,  // all positions, any number of times, then the faces once
  repeatedly        // positions and faces, any number of times
};

// Where there are only faces, a pass over positions gives all their corners, or only the first of
// each, which is enough to meet (nearly) every vertex.
enum class PassCorners { all, first };

// Two steps a pass: next_*() is for one thread at a time and finds where batches begin and end;
// decode_*() does the work, in `slice`, which it hands to the sink, and may run for many batches at
// once. Errors: Error(bad_input), naming file and place.
class MeshReader {
 public:
  virtual ~MeshReader() = default;

  [[nodiscard]] const InputFacts& facts() const { return facts_; }

  virtual void begin_positions(PassCorners corners) = 0;
  virtual bool next_positions(RawBatch& batch) = 0;
  virtual void decode_positions(const RawBatch& batch, FaceBatch& slice,
                                const PositionSink& sink) const = 0;

  virtual void begin_faces() = 0;
  virtual bool next_faces(RawBatch& batch) = 0;
  virtual void decode_faces(const RawBatch& batch, FaceBatch& slice,
                            const FaceSink& sink) const = 0;

  // After a pass's last batch, when none is under way any more: whether the pass goes on, with
  // another file of the same input.
  virtual bool next_part() { return false; }

  // The first position all of whose coordinates are finite, in the input's order; nothing if there
  // is none. To be called before begin_faces(); costs next to nothing.
  virtual std::optional<std::array<double, 3>> first_finite_position() = 0;

  // Of each attribute that is carried the largest size of a number, or a bound for it, over all
  // vertices, and how many vertices are without: their number is not finite, or the largest that a
  // float or double can be. To be called before begin_faces().
  struct AttributeRange {
    double largest = 0;
    std::uint64_t without = 0;
  };
  virtual std::vector<AttributeRange> attribute_ranges() { return {}; }

  // Appends what the vertices of a PositionView carry, as it is stored, vertex by vertex; from any
  // thread, while the view is there. Readers of a single input have it.
  virtual void read_attributes(const PositionView& /*view*/, std::vector<double>& /*out*/) const {}

  // Gives back memory that only a pass needs; the next begin_...() takes it again.
  virtual void release_memory() {}

  // Throws Error(bad_input) if the file has become shorter since it was opened.
  virtual void check_whole() const = 0;

  // Bytes of plain content seen so far.
  [[nodiscard]] virtual std::uint64_t bytes() const = 0;
  [[nodiscard]] virtual const std::string& name() const = 0;

 protected:
  InputFacts facts_;
};

// Memory that a reader may use besides the blocks in flight, and how freely.
struct ReaderMemory {
  std::uint64_t vertices = 0;      // for stored or mapped vertices
  std::size_t batch_faces = 8192;  // faces a raw batch
  bool any_order = false;         // of faces will do, where another than that of the file is faster
  bool polygons_as_fans = false;  // around their first corners, wherever those are
};

// Finds the format by content where `from` says automatic. Takes the source; copies it to scratch
// first where `access` asks for what the source cannot do. Throws Error(usage) where `wish` names
// what the input lacks.
std::unique_ptr<MeshReader> open_reader(Job& job, std::unique_ptr<ByteSource> source, Format from,
                                        Access access, const ReaderMemory& memory,
                                        const AttributeRequest& wish = {});

// The same, without touching more than the first bytes: what would be read, and how.
struct InputProbe {
  InputFacts facts;
  std::optional<std::uint64_t> bytes;
  bool copied_first = false;  // the whole input goes to scratch before anything else
  bool vertices_buffered =
      false;  // vertices are decoded into memory or scratch, not looked up in the file
  std::uint64_t vertex_bytes = 0;  // of one where they are looked up in the file
  bool faces_buffered = false;     // faces stand before the vertices and wait in scratch
  bool taken_in = false;           // all is parsed into memory or scratch before anything else
  std::string compression;
};
InputProbe probe_input(Job& job, ByteSource& source, Format from, Access access,
                       const AttributeRequest& wish = {});

}  // namespace winnow
