// Bytes in: a mapped file, a file, a pipe, or the decompressed content of any of them.
#pragma once

#include "io/file_descriptor.hpp"
#include "io/job.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace winnow {

class MappedWindow;

// Bytes that stay where they are for as long as the block, or a copy of it, lives.
struct Block {
  std::span<const std::byte> bytes;
  std::uint64_t offset = 0;  // of the first byte in the whole content
  std::shared_ptr<const void> owner;
  const MappedWindow* window = nullptr;  // where the bytes are mapped

  // Throws Error(bad_input) if the mapped file shrank under these bytes. To be asked after they
  // were used.
  void check_intact(const std::string& name) const;
};

// Read from front to back, by one thread at a time; the blocks may then be used by any.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  // The next `bytes` bytes; fewer only at the end of the content.
  virtual Block take(std::size_t bytes) = 0;

  // Un-reads the last bytes of the block taken last.
  virtual void give_back(std::size_t bytes) = 0;

  [[nodiscard]] virtual std::uint64_t position() const = 0;
  [[nodiscard]] virtual std::optional<std::uint64_t> size()
      const = 0;  // of the content, where it is known

  // Whether seek() works: true for plain files, false for pipes and compressed content.
  [[nodiscard]] virtual bool seekable() const = 0;
  virtual void seek(std::uint64_t position) = 0;

  // The name to map the content by; empty where it cannot be mapped.
  [[nodiscard]] virtual std::string map_name() const { return {}; }

  // Where the content was copied to: whoever maps it checks it. Null where it was not.
  [[nodiscard]] virtual std::shared_ptr<const ScratchFile> scratch() const { return nullptr; }

  // Of a file, also a compressed one, as it was opened.
  [[nodiscard]] virtual std::optional<FileVersion> version() const { return {}; }

  // Throws Error(bad_input) if the file is shorter than it was when it was opened, or was changed
  // and is as long as before.
  virtual void check_whole() const {}

  [[nodiscard]] const std::string& name() const { return name_; }  // for messages
  [[nodiscard]] const std::string& compression() const {
    return compression_;
  }  // "", "gzip" or "zstd"

  // The next bytes without reading past them.
  Block peek(std::size_t bytes);

 protected:
  ByteSource(std::string name, std::string compression)
      : name_(std::move(name)), compression_(std::move(compression)) {}

 private:
  std::string name_;
  std::string compression_;
};

enum class Unpacking { by_content, none };

// Throws Error(usage) where the file `name`, which is read, is an output of the run.
void refuse_output(const Job& job, const FileNumber& file, const std::string& name);

// Opens a file, or standard input for "-"; sees through gzip and zstd, unless it is not to. Throws
// Error(bad_input), or Error(resources) where the system has no more descriptors or memory.
std::unique_ptr<ByteSource> open_source(Job& job, const std::string& path,
                                        Unpacking unpacking = Unpacking::by_content);

// The content of `source` from its beginning, copied to scratch, so that it can be read again.
// `source` must not have been read from.
std::unique_ptr<ByteSource> copy_to_scratch(Job& job, std::unique_ptr<ByteSource> source);

}  // namespace winnow
