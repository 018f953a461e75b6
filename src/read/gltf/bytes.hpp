// The bytes behind a glTF's buffer views: in the GLB, beside the file, in the JSON itself, or
// packed.
#pragma once

#include "io/byte_source.hpp"
#include "read/gltf/document.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// For one thread. Nothing is taken for a size that the file does not bear out; what has to be held
// in memory (data of the JSON, packed views) is reserved from the budget.
class GltfBytes {
 public:
  // `source` is the file itself, which can be sought in and holds the GLB's own buffer from `begin`
  // on.
  GltfBytes(Job& job, ByteSource& source, std::uint64_t begin, std::uint64_t bytes,
            const GltfDocument& document)
      : job_(job), source_(source), own_begin_(begin), own_bytes_(bytes), document_(document) {}

  // What is read from now on is read in turn, and what was read before may not be read again.
  void begin_part() { ++part_; }

  // Part of a view, valid until the next call. Throws Error(bad_input) where it reaches behind the
  // view or the view's buffer is not there.
  std::span<const std::byte> read(std::size_t view, std::uint64_t offset, std::size_t bytes);

 private:
  // Content of a buffer: a part of a file, or bytes in memory.
  struct Content {
    ByteSource* file = nullptr;
    std::unique_ptr<ByteSource> owned;
    std::uint64_t begin = 0, bytes = 0;
    std::vector<std::byte> memory;
    Reservation reserved;
    std::uint64_t part = 0;  // that it was last used for
  };

  [[noreturn]] void fail(const std::string& what) const;
  Content& buffer(std::size_t index);
  void close_one_of_many();
  std::unique_ptr<ByteSource> open_beside(const std::string& uri);
  void decode_base64(std::string_view text, Content& into);
  std::span<const std::byte> read_content(Content& content, std::uint64_t offset,
                                          std::size_t bytes);
  void set_aside();  // what is unpacked for this part, to scratch; all else is dropped
  Content& unpacked(std::size_t view, const GltfPacking& packing);

  Job& job_;
  ByteSource& source_;
  std::uint64_t own_begin_, own_bytes_;
  const GltfDocument& document_;
  std::map<std::size_t, Content> buffers_;
  std::map<std::size_t, Content> unpacked_;
  std::uint64_t part_ = 0;
  Block last_;
};

}  // namespace winnow
