// Faces that jump from one to the next, though the vertices of each are near each other, as in a
// file whose faces were shuffled.
#pragma once

#include "io/job.hpp"
#include "read/indexed/parts.hpp"
#include "read/mesh_reader.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace winnow {

// The faces in scratch, those of neighbouring vertices together: then looking vertices up touches a
// few pages at a time, and so does clustering. For whoever does not mind in which order faces come.
class SortedFaces {
 public:
  struct Plan {
    std::uint64_t near = 0;  // vertices of a face are at most so many numbers apart ...
    std::size_t parts = 0;   // ... but in the last part, which has all other faces
    unsigned part_bits =
        0;  // faces of a part have a first vertex whose number has the same higher bits
    std::size_t buffer_bytes = 0;
  };
  // Nothing where looking up the vertices of a part in `memory` takes more parts than files should
  // be open.
  static std::optional<Plan> plan(std::uint64_t vertices, std::size_t record_bytes,
                                  std::uint64_t memory);

  // Vertices of a face whose numbers are farther apart than this are not near.
  static std::uint64_t near(std::size_t record_bytes, std::uint64_t memory);

  SortedFaces(Job& job, const Plan& plan) : job_(job), plan_(plan) {}

  // Takes in all faces, `count` if that is known: next() gives them as indices or as what `indices`
  // makes such of, on any thread.
  void build(const NextFaces& next, const std::function<void(RawBatch&)>& indices,
             std::uint64_t count);

  static constexpr std::uint64_t bytes_a_face = 16;

  // Passes over them, by one thread.
  void begin() { part_ = place_ = 0; }
  // The next, at most `most`, as indices, status, numbers and count; false at the end.
  bool next(std::size_t most, RawBatch& batch);

 private:
  struct Face {
    std::array<std::uint32_t, 3> corner;
    std::uint32_t number;  // in the input, the low 32 bits
  };
  static_assert(sizeof(Face) == bytes_a_face);

  [[nodiscard]] std::size_t part_of(const Face& face) const;

  Job& job_;
  Plan plan_;
  PartFiles files_;
  std::size_t part_ = 0;     // of the next face ...
  std::uint64_t place_ = 0;  // ... and its number there
  std::vector<Face> read_;
};

}  // namespace winnow
