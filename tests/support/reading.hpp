// A mesh read through the library, as plain lists.
#pragma once

#include "read/mesh_reader.hpp"
#include "support/job.hpp"
#include "support/polygons.hpp"

#include <memory>
#include <string>
#include <vector>

namespace winnow::test {

inline constexpr std::uint64_t usual_vertex_memory = std::uint64_t{32} << 20;

// All faces in their order, with all threads of the job. Throws std::logic_error where the batches
// do not fit together.
std::vector<SeenFace> read_faces(Job& job, MeshReader& reader);

// All positions in their order; where there are only faces, corner by corner of each.
std::vector<Point> read_positions(Job& job, MeshReader& reader);

// After a first pass, which gave `faces`: positions and the same faces come from the scratch that
// there is, within the memory for vertices.
void check_later_passes(Job& job, MeshReader& reader, const ReaderMemory& memory,
                        const std::vector<SeenFace>& faces);

struct ReadStyle {
  Format format = Format::automatic;
  Access access = Access::once;
  ReaderMemory memory{usual_vertex_memory, 8192};
};

// The faces of a whole content.
std::vector<SeenFace> faces_of(Job& job, std::unique_ptr<ByteSource> source,
                               const ReadStyle& style = {});
std::vector<SeenFace> faces_of(const std::string& content,
                               const ReadStyle& style = {});  // as a file ...
std::vector<SeenFace> faces_of_pipe(const std::string& content,
                                    const ReadStyle& style = {});  // ... or as a pipe

// What the faces of a whole content carry by their corners.
struct Carried {
  std::vector<std::string> attributes;  // "red (uchar)"
  std::vector<double> numbers;          // attribute by attribute, of all faces, corner by corner
  InputFacts facts;
};
Carried carried_by(std::unique_ptr<ByteSource> source,
                   std::uint64_t memory = std::uint64_t{512} << 20,
                   std::uint64_t vertex_memory = usual_vertex_memory);

}  // namespace winnow::test
