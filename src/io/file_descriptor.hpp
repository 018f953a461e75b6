// Plain sequential reading of an open file or pipe.
#pragma once

#include <winnow/error.hpp>

#include "io/job.hpp"
#include "io/watched_files.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// What kind of error it is that an input cannot be opened, by errno: not the input's fault where
// the system has no more of something.
ErrorKind cannot_open(int code);

// A stream of bytes, read by one thread at a time.
class ByteStream {
 public:
  virtual ~ByteStream() = default;
  virtual std::size_t read(std::span<std::byte> into) = 0;  // some bytes; 0 only at the end
  [[nodiscard]] virtual bool seekable() const { return false; }
  virtual void seek(std::uint64_t /*position*/) {}
  [[nodiscard]] virtual std::optional<std::uint64_t> size() const { return {}; }
  // Of a file, as it was opened.
  [[nodiscard]] virtual std::optional<FileVersion> version() const { return {}; }
  // Throws Error(bad_input) if a file has become shorter, or was changed and is as long as before.
  virtual void check_whole() const {}
};

[[noreturn]] void shortened(const std::string& name, std::uint64_t offset);
[[noreturn]] void changed(const std::string& name);

// Waiting for a pipe ends when the run is cancelled.
class DescriptorStream final : public ByteStream {
 public:
  DescriptorStream(Job& job, int fd, std::string name);  // takes the descriptor
  ~DescriptorStream() override;
  DescriptorStream(const DescriptorStream&) = delete;
  DescriptorStream& operator=(const DescriptorStream&) = delete;

  std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] bool seekable() const override { return size_.has_value(); }
  void seek(std::uint64_t position) override;
  [[nodiscard]] std::optional<std::uint64_t> size() const override { return size_; }
  [[nodiscard]] std::optional<FileVersion> version() const override { return version_; }
  void check_whole() const override;
  [[nodiscard]] bool is_directory() const { return directory_; }
  [[nodiscard]] int descriptor() const { return fd_; }
  [[nodiscard]] FileNumber number() const { return number_; }

 private:
  Job& job_;
  int fd_;
  std::string name_;
  std::uint64_t position_ = 0;
  std::optional<std::uint64_t> size_;   // only of a regular file read from its beginning
  std::optional<FileVersion> version_;  // likewise
  FileNumber number_;
  bool directory_ = false;
};

// A few bytes that were read already, and then the rest.
class PrefixedStream final : public ByteStream {
 public:
  PrefixedStream(std::vector<std::byte> prefix, std::unique_ptr<ByteStream> rest)
      : prefix_(std::move(prefix)), rest_(std::move(rest)) {}
  std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] std::optional<FileVersion> version() const override { return rest_->version(); }
  void check_whole() const override { rest_->check_whole(); }

 private:
  std::vector<std::byte> prefix_;
  std::size_t given_ = 0;
  std::unique_ptr<ByteStream> rest_;
};

}  // namespace winnow
