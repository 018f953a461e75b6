#include "io/byte_source.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "io/compressed.hpp"
#include "io/file_descriptor.hpp"
#include "io/mapped_window.hpp"
#include "io/read_ahead.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow {

void Block::check_intact(const std::string& name) const {
  if (window != nullptr && window->damaged()) shortened(name, offset);
}

Block ByteSource::peek(std::size_t bytes) {
  Block block = take(bytes);
  give_back(block.bytes.size());
  return block;
}

namespace {

// A window is large enough that mapping costs little, and small enough that a few of them in flight
// fit into the smallest budget.
constexpr std::size_t window_bytes = std::size_t{2} << 20;

class MappedSource final : public ByteSource {
 public:
  // `stream` holds whatever `path` refers to alive, and watches it.
  MappedSource(std::string name, const std::string& path, std::uint64_t size,
               std::shared_ptr<const ByteStream> stream)
      : ByteSource(std::move(name), ""),
        path_(path),
        stream_(std::move(stream)),
        file_(map_file(path)),
        size_(size),
        ahead_(file_.get_mapping_handle().handle, size) {}

  MappedSource(std::string name, std::shared_ptr<const ScratchFile> file)
      : MappedSource(std::move(name), file->path(), file->size(), nullptr) {
    scratch_ = std::move(file);
  }

  Block take(std::size_t bytes) override {
    const std::size_t wanted = std::min<std::uint64_t>(bytes, size_ - position_);
    if (wanted == 0) return {};
    if (window_ == nullptr || position_ < start_ || position_ + wanted > start_ + window_->size()) {
      const std::size_t length =
          std::min<std::uint64_t>(std::max(wanted, window_bytes), size_ - position_);
      window_.reset();
      window_ = std::make_shared<MappedWindow>(file_, position_, length);
      start_ = position_;
      ahead_.reached(start_, start_ + length);
      if (scratch_ != nullptr) scratch_->check(start_, length);
    }
    Block block{
        {window_->data() + (position_ - start_), wanted}, position_, window_, window_.get()};
    position_ += wanted;
    return block;
  }

  void give_back(std::size_t bytes) override { position_ -= bytes; }
  [[nodiscard]] std::uint64_t position() const override { return position_; }
  [[nodiscard]] std::optional<std::uint64_t> size() const override { return size_; }
  [[nodiscard]] bool seekable() const override { return true; }
  void seek(std::uint64_t position) override {
    position_ = std::min(position, size_);
    if (window_ != nullptr && window_->size() > window_bytes)
      window_.reset();  // memory that one question took
    ahead_.start_again();
  }
  [[nodiscard]] std::string map_name() const override { return path_; }
  [[nodiscard]] std::shared_ptr<const ScratchFile> scratch() const override { return scratch_; }

  [[nodiscard]] std::optional<FileVersion> version() const override {
    return stream_ == nullptr ? std::nullopt : stream_->version();
  }

  // The end of a page that the file shrank into reads as zeros and raises no signal: the size has
  // to be asked.
  void check_whole() const override {
    if (stream_ != nullptr) stream_->check_whole();
  }

 private:
  std::string path_;
  std::shared_ptr<const ByteStream> stream_;    // null of scratch
  std::shared_ptr<const ScratchFile> scratch_;  // where it is one
  boost::interprocess::file_mapping file_;
  std::uint64_t size_;
  ReadAhead ahead_;
  std::uint64_t position_ = 0;
  std::uint64_t start_ = 0;
  std::shared_ptr<MappedWindow> window_;
};

// Everything that is not mapped goes through blocks on the heap.
class StreamSource final : public ByteSource {
 public:
  StreamSource(std::string name, std::string compression, std::unique_ptr<ByteStream> stream)
      : ByteSource(std::move(name), std::move(compression)), stream_(std::move(stream)) {}

  Block take(std::size_t bytes) override {
    if (end_ - begin_ < bytes && !ended_) refill(bytes);
    const std::size_t length = std::min(bytes, end_ - begin_);
    Block block{
        {length == 0 ? nullptr : buffer_->data() + begin_, length}, position_, buffer_, nullptr};
    begin_ += length;
    position_ += length;
    return block;
  }

  void give_back(std::size_t bytes) override {
    begin_ -= bytes;
    position_ -= bytes;
  }
  [[nodiscard]] std::uint64_t position() const override { return position_; }
  [[nodiscard]] std::optional<std::uint64_t> size() const override { return stream_->size(); }
  [[nodiscard]] bool seekable() const override { return stream_->seekable(); }

  [[nodiscard]] std::optional<FileVersion> version() const override { return stream_->version(); }
  void check_whole() const override { stream_->check_whole(); }
  void seek(std::uint64_t position) override {
    stream_->seek(position);
    position_ = position;
    begin_ = end_ = 0;
    buffer_.reset();
    ended_ = false;
  }

 private:
  // Blocks of the old buffer may still be in use: the rest moves to the front of a new one.
  void refill(std::size_t bytes) {
    constexpr std::size_t usual = std::size_t{1} << 20;
    const std::size_t rest = end_ - begin_;
    auto fresh = std::make_shared<std::vector<std::byte>>(std::max(bytes, usual));
    if (rest != 0) std::memcpy(fresh->data(), buffer_->data() + begin_, rest);
    std::size_t filled = rest;
    while (filled < bytes) {
      const std::size_t got = stream_->read({fresh->data() + filled, fresh->size() - filled});
      if (got == 0) {
        ended_ = true;
        break;
      }
      filled += got;
    }
    buffer_ = std::move(fresh);
    begin_ = 0;
    end_ = filled;
  }

  std::unique_ptr<ByteStream> stream_;
  std::shared_ptr<std::vector<std::byte>> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  std::uint64_t position_ = 0;
  bool ended_ = false;
};

}  // namespace

namespace {

// Without waiting: a named pipe that nobody writes to yet is waited for where cancelling is
// noticed.
int open_input(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd >= 0) ::fcntl(fd, F_SETFL, ::fcntl(fd, F_GETFL) & ~O_NONBLOCK);
  return fd;
}

}  // namespace

void refuse_output(const Job& job, const FileNumber& file, const std::string& name) {
  if (std::find(job.written_over.begin(), job.written_over.end(), file) == job.written_over.end())
    return;
  throw Error(ErrorKind::usage,
              "'" + name + "' is read, so it cannot be the output as well; name another output");
}

std::unique_ptr<ByteSource> open_source(Job& job, const std::string& path, Unpacking unpacking) {
  const bool standard = path == "-";
  std::string name = standard ? "standard input" : path;
  const int fd = standard ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3) : open_input(path);
  if (fd < 0)
    throw Error(cannot_open(errno), "cannot open '" + name + "': " + std::strerror(errno));
  auto file = std::make_unique<DescriptorStream>(job, fd, name);
  if (file->is_directory())
    throw Error(ErrorKind::bad_input, "'" + path + "' is a directory, not a mesh file");

  refuse_output(job, file->number(), name);

  std::vector<std::byte> head(4);
  std::size_t filled = 0;
  while (filled < head.size()) {
    const std::size_t got = file->read(std::span(head).subspan(filled));
    if (got == 0) break;
    filled += got;
  }
  head.resize(filled);
  const std::string compression = unpacking == Unpacking::by_content ? compression_of(head) : "";

  if (compression.empty() && file->seekable()) {
    if (job.context.map_input && *file->size() > 0) {
      const std::string map_path =
          standard ? "/proc/self/fd/" + std::to_string(file->descriptor()) : path;
      const std::uint64_t size = *file->size();
      return std::make_unique<MappedSource>(std::move(name), map_path, size, std::move(file));
    }
    file->seek(0);
    return std::make_unique<StreamSource>(std::move(name), "", std::move(file));
  }
  auto whole = std::make_unique<PrefixedStream>(std::move(head), std::move(file));
  if (compression.empty())
    return std::make_unique<StreamSource>(std::move(name), "", std::move(whole));
  auto plain = decompress(job, name, compression, std::move(whole));
  return std::make_unique<StreamSource>(std::move(name), compression, std::move(plain));
}

std::unique_ptr<ByteSource> copy_to_scratch(Job& job, std::unique_ptr<ByteSource> source) {
  job.progress.begin("copy the input to scratch", source->size().value_or(0), "bytes");
  auto file = std::make_shared<ScratchFile>(job.scratch);
  for (;;) {
    const Block block = source->take(std::size_t{1} << 20);
    if (block.bytes.empty()) break;
    file->append(block.bytes);
    job.progress.advance(block.bytes.size());
  }
  source->check_whole();
  if (file->size() == 0) throw Error(ErrorKind::bad_input, "'" + source->name() + "' is empty");
  return std::make_unique<MappedSource>(source->name(), std::move(file));
}

}  // namespace winnow
