// What a run reads: one file or pipe, or several files as one model, or arrays of the caller; whole
// or cropped.
#pragma once

#include <winnow/mesh.hpp>
#include <winnow/simplify.hpp>

#include "io/byte_source.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace winnow {

class Input {
 public:
  // Opens what there is, so that the memory to decompress it shows. Throws Error: usage, bad_input.
  Input(Job& job, const std::vector<std::string>& names);

  explicit Input(Job& job, std::unique_ptr<ByteSource> source);

  // Arrays that outlive it. Throws Error: usage, bad_input.
  explicit Input(Job& job, const MeshView& mesh);

  // What of the budget it takes before the rest can be divided.
  [[nodiscard]] std::uint64_t memory() const { return memory_; }

  // What would be read, from the first bytes; to be called before reader(). Throws Error(usage)
  // where `wish` names what the input lacks.
  InputProbe probe(const SimplifyOptions& options, Access access, const AttributeRequest& wish);
  // To be called once.
  std::unique_ptr<MeshReader> reader(const SimplifyOptions& options, Access access,
                                     const AttributeRequest& wish, const ReaderMemory& memory);

 private:
  Job& job_;
  std::vector<std::string> names_;
  std::unique_ptr<ByteSource> source_;  // of a single one
  const MeshView* mesh_ = nullptr;      // of arrays
  std::uint64_t memory_ = 0;
};

// For an input in which no face was found: "could be" what. Throws Error(bad_input).
[[noreturn]] void refuse_without_faces(const MeshReader& reader, const std::string& purpose);

}  // namespace winnow
