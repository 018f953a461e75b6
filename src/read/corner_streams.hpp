// The vertices of faces that jump, brought together in scratch in the order of the faces.
#pragma once

#include "io/job.hpp"
#include "read/indexed/packed_records.hpp"
#include "read/indexed/parts.hpp"
#include "read/indexed/vertex_store.hpp"
#include "read/mesh_reader.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace winnow {

// Looking up vertices anywhere in a file larger than memory costs a page for each. Here everything
// is read and written from front to back. Vertices are divided into parts that fit into memory. A
// first pass over the faces appends each corner's vertex number to the stream of its part. Then,
// part after part, the vertices are loaded, and each number of the stream is replaced by its
// vertex's record. In any later pass a corner's record is the next one of its part's stream:
// neither the order of the faces nor a place has to be kept, and nothing is sorted.
class CornerStreams {
 public:
  // How memory is divided.
  struct Plan {
    unsigned part_bits = 0;         // a part has so many bits of vertex numbers
    std::size_t parts = 0;          // each a file
    std::size_t buffer_bytes = 0;   // of each part, while numbers are appended
    std::size_t chunk_corners = 0;  // looked up at once
    std::size_t chunks = 0;         // on their way at one time
    std::size_t batch_faces = 0;    // of a pass, at the most
  };
  // Nothing where `memory` would need more parts than files should be open.
  static std::optional<Plan> plan(std::uint64_t vertices, std::size_t record_bytes,
                                  std::uint64_t memory, unsigned threads);

  // Scratch a face takes, at the most.
  static constexpr std::uint64_t bytes_a_face(std::size_t record_bytes) {
    return 3 * (sizeof(std::uint32_t) + record_bytes);
  }

  CornerStreams(Job& job, const VertexStore& vertices, const Plan& plan);

  // The vertex numbers of a batch's corners, three a face, from any thread.
  using CornerNumbers = std::function<void(const RawBatch&, std::vector<std::uint32_t>&)>;
  // Takes in all faces, `count` if that is known.
  void build(const NextFaces& next, const CornerNumbers& numbers, std::uint64_t count);

  // Passes over the faces, the same as before, by one thread; what memory they take is reserved
  // until rest().
  void begin();
  // Gives a batch of indices the records of its corners.
  void add_records(RawBatch& batch);
  void release_memory() { reservation_.release(); }

  // Where in a batch the next record of each part stands.
  using Cursors = std::vector<std::uint32_t>;
  // Positions of the next faces of `batch`, by the numbers of their vertices, all of which there
  // are. From any thread.
  void gather(const RawBatch& batch, Cursors& cursors,
              const std::array<const std::uint32_t*, 3>& index, std::size_t count,
              FaceBatch& out) const;

 private:
  void sort_by_part(const NextFaces& next, const CornerNumbers& numbers, std::uint64_t count);
  void look_up();
  void load(std::size_t part, std::byte* into) const;
  void look_up(std::size_t part, const std::byte* vertices);

  // Of corners in their parts' order, where each part begins, and the end of the last.
  [[nodiscard]] std::vector<std::uint32_t> begins_of(std::span<const std::uint32_t> numbers) const;

  // As lookups do, which take the first vertex where there is none of the number.
  [[nodiscard]] std::uint32_t existing(std::uint32_t number) const {
    return number < vertices_.size() ? number : 0;
  }

  Job& job_;
  const VertexStore& vertices_;
  Plan plan_;
  PackedRecords packed_;
  PartFiles numbers_;  // in their parts, until they are looked up
  PartFiles records_;
  std::vector<std::uint64_t> next_;  // record of each part, in a pass
  Reservation reservation_;
};

}  // namespace winnow
