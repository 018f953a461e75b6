// A progressive file that is played: splits are applied to its base up to some count, and taken
// back.
#pragma once

#include "base/budget.hpp"
#include "io/byte_source.hpp"
#include "io/job.hpp"
#include "io/scratch_memory.hpp"
#include "progressive/file_header.hpp"
#include "progressive/split_codec.hpp"
#include "progressive/split_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace winnow {

class SplitPlayer {
 public:
  // Reads the header and the base. `back`: steps can be taken back; then the source has to be
  // seekable. Throws Error(bad_input) where the file is damaged, or cut short before the base ends.
  SplitPlayer(Job& job, std::unique_ptr<ByteSource> source, bool back);

  [[nodiscard]] const ProgressiveHeader& header() const { return header_; }
  [[nodiscard]] const VertexWords& words() const { return words_; }
  [[nodiscard]] const SplitMesh& mesh() const { return *mesh_; }

  // Reserves memory for so many faces, once for all that is to come.
  void expect(std::uint64_t faces);
  // The same in scratch, which has to stay. No step can be taken back.
  void expect(std::uint64_t faces, ScratchMemory& scratch);

  // One split. False where there is none: at full count, or where the file is cut short.
  bool forward();
  // Takes the last one back. False at the base.
  bool backward();
  // To the most faces that are no more than this; there may be a split less.
  void go_to(std::uint64_t faces);

  // From the beginning, of the chunks that were looked at.
  [[nodiscard]] std::uint64_t bytes_read() const { return header_.counts(chunk_).bytes; }

  // The file ends before its last chunk does: faces beyond those of mesh() are not there.
  [[nodiscard]] bool cut_short() const { return cut_short_; }

 private:
  // Of a split that was applied.
  struct Done {
    SplitMesh::Undo undo;
    std::size_t chunk;  // which it is the first of; else no_chunk
  };
  static constexpr std::size_t no_chunk = SIZE_MAX;

  void read_base();
  // The next split; null where there is none.
  const Split* next();
  bool open_chunk();
  [[nodiscard]] std::vector<std::byte> chunk_bytes(const ChunkEntry& entry);
  [[nodiscard]] std::uint64_t memory_for(std::uint64_t vertices, std::uint64_t faces) const;
  void make_room(std::uint64_t vertices, std::uint64_t faces);
  void take_room(std::uint64_t vertices, std::uint64_t faces, Reservation memory);
  void grow();
  void apply(const Split& split, bool last_of_chunk);
  // Goes on from the beginning of this chunk.
  void rewind_to(std::size_t chunk);
  [[noreturn]] void refuse_chunk(std::size_t chunk, const std::string& why) const;

  Job& job_;
  std::unique_ptr<ByteSource> source_;
  bool back_;
  ProgressiveHeader header_;
  VertexWords words_;
  std::optional<SplitMesh> mesh_;
  ScratchMemory* scratch_ = nullptr;  // where the mesh is, or null
  Reservation mesh_memory_, chunk_memory_;
  std::uint64_t room_vertices_ = 0, room_faces_ = 0;

  std::size_t chunk_ = 0;            // the next one
  ProgressiveHeader::Counts end_{};  // of the mesh at the end of the chunk that is open
  std::optional<SplitDecoder> decoder_;
  bool chunk_begins_ = false;
  bool cut_short_ = false;
  Split decoded_;  // the next one of the chunk
  bool has_decoded_ = false;
  std::vector<Split> undone_;  // come before it, the very next at the back
  std::vector<Done> done_;
};

}  // namespace winnow
