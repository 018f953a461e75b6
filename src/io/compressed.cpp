#include "io/compressed.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include <zlib.h>
#define ZSTD_STATIC_LINKING_ONLY  // for ZSTD_getFrameHeader
#include <zstd.h>

namespace winnow {

std::string compression_of(std::span<const std::byte> head) {
  const auto starts = [&](std::initializer_list<unsigned char> magic) {
    return head.size() >= magic.size() &&
           std::memcmp(head.data(), magic.begin(), magic.size()) == 0;
  };
  if (starts({0x1f, 0x8b})) return "gzip";
  if (starts({0x28, 0xb5, 0x2f, 0xfd})) return "zstd";
  // A frame that is skipped comes first in all that pzstd writes; its number is free.
  if (head.size() >= 4 && (head[0] & std::byte{0xf0}) == std::byte{0x50} &&
      std::memcmp(head.data() + 1, "\x2a\x4d\x18", 3) == 0) {
    return "zstd";
  }
  return "";
}

namespace {

// What is packed, as it is read.
class PackedBytes {
 public:
  explicit PackedBytes(std::unique_ptr<ByteStream> stream) : stream_(std::move(stream)) {}

  // Makes at least so many bytes available, unless the content ends.
  void fill(std::size_t wanted) {
    if (left().size() >= wanted) return;
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= std::exchange(begin_, 0);
    while (end_ < wanted) {
      const std::size_t got = stream_->read(std::span(buffer_).subspan(end_));
      if (got == 0) return;
      end_ += got;
      read_ += got;
    }
  }

  [[nodiscard]] std::span<std::byte> left() { return {buffer_.data() + begin_, end_ - begin_}; }
  void pass_over(std::size_t bytes) { begin_ += bytes; }

  // Of the first byte that is left.
  [[nodiscard]] std::uint64_t offset() const { return read_ - (end_ - begin_); }

  [[nodiscard]] const ByteStream& stream() const { return *stream_; }

 private:
  std::unique_ptr<ByteStream> stream_;
  std::vector<std::byte> buffer_ = std::vector<std::byte>(std::size_t{1} << 17);
  std::size_t begin_ = 0, end_ = 0;
  std::uint64_t read_ = 0;
};

class PackedStream : public ByteStream {
 public:
  PackedStream(Job& job, std::string name, std::string compression,
               std::unique_ptr<ByteStream> stream)
      : job_(job),
        name_(std::move(name)),
        packed_(std::move(stream)),
        compression_(std::move(compression)) {}

  std::size_t read(std::span<std::byte> into) final {
    const std::size_t got = unpack(into);
    position_ += got;
    return got;
  }

  [[nodiscard]] std::optional<FileVersion> version() const final {
    return packed_.stream().version();
  }
  void check_whole() const final { packed_.stream().check_whole(); }

 protected:
  virtual std::size_t unpack(std::span<std::byte> into) = 0;

  // `how` it is: "ends" or "breaks"; `unpacked`: in this call.
  [[noreturn]] void damaged(const std::string& how, std::size_t unpacked) {
    throw Error(ErrorKind::bad_input,
                "'" + name_ + "' is damaged or cut short: its " + compression_ + " content " + how +
                    " at byte " + grouped(packed_.offset()) + ", after " +
                    grouped(position_ + unpacked) + " bytes of plain content");
  }

  Job& job_;
  std::string name_;
  PackedBytes packed_;

 private:
  std::string compression_;
  std::uint64_t position_ = 0;
};

// As the program gzip has it: members follow each other, and what follows them is ignored; zeros,
// which pad tapes and blocks, in silence. zlib itself passes over the names and comments in
// headers.
class GzipStream final : public PackedStream {
 public:
  GzipStream(Job& job, std::string name, std::unique_ptr<ByteStream> stream)
      : PackedStream(job, std::move(name), "gzip", std::move(stream)) {
    constexpr int gzip_header = 16;
    if (::inflateInit2(&state_, MAX_WBITS + gzip_header) != Z_OK)
      throw Error(ErrorKind::resources, "no memory for a gzip decoder");
  }
  ~GzipStream() override { ::inflateEnd(&state_); }
  GzipStream(const GzipStream&) = delete;
  GzipStream& operator=(const GzipStream&) = delete;

 private:
  std::size_t unpack(std::span<std::byte> into) override {
    std::size_t unpacked = 0;
    while (unpacked == 0 && !ended_) {
      job_.progress.check_cancelled();
      if (at_member_begin_ && !begin_member()) break;
      packed_.fill(1);
      const std::span<std::byte> left = packed_.left();
      if (left.empty()) damaged("ends", 0);
      state_.next_in = reinterpret_cast<Bytef*>(left.data());
      state_.avail_in = static_cast<uInt>(left.size());
      state_.next_out = reinterpret_cast<Bytef*>(into.data());
      const auto room = static_cast<uInt>(std::min<std::size_t>(into.size(), std::size_t{1} << 30));
      state_.avail_out = room;
      const int result = ::inflate(&state_, Z_NO_FLUSH);
      packed_.pass_over(left.size() - state_.avail_in);
      unpacked = room - state_.avail_out;
      if (result == Z_STREAM_END) {
        at_member_begin_ = true;
      } else if (result != Z_OK) {
        damaged("breaks", unpacked);
      }
    }
    return unpacked;
  }

  // False where there is none, and nothing more is to be read.
  bool begin_member() {
    packed_.fill(2);
    const std::span<std::byte> left = packed_.left();
    if (left.size() == 1 && left[0] == std::byte{0x1f})
      damaged("ends", 0);  // the first of a member
    at_member_begin_ = compression_of(left) != "gzip";
    if (!at_member_begin_) return ::inflateReset(&state_) == Z_OK;
    ended_ = true;
    bool zeros = true;
    for (; !packed_.left().empty(); packed_.fill(1)) {
      const std::span<std::byte> part = packed_.left();
      zeros = zeros &&
              std::all_of(part.begin(), part.end(), [](std::byte b) { return b == std::byte{}; });
      packed_.pass_over(part.size());
      job_.progress.check_cancelled();
    }
    if (!zeros) job_.note("what stands behind the gzip content of '" + name_ + "' was ignored");
    return false;
  }

  z_stream state_{};
  bool at_member_begin_ = true;
  bool ended_ = false;
};

// Boost's zstd filter takes the end of a cut file for the end of its content, and stops after the
// first of several frames; so the library is asked directly.
class ZstdStream final : public PackedStream {
 public:
  ZstdStream(Job& job, std::string name, std::unique_ptr<ByteStream> stream)
      : PackedStream(job, std::move(name), "zstd", std::move(stream)),
        decoder_(ZSTD_createDCtx(), ZSTD_freeDCtx) {
    if (decoder_ == nullptr) throw Error(ErrorKind::resources, "no memory for a zstd decoder");
    ZSTD_DCtx_setParameter(decoder_.get(), ZSTD_d_windowLogMax, ZSTD_WINDOWLOG_LIMIT_DEFAULT);
  }

 private:
  std::size_t unpack(std::span<std::byte> into) override {
    ZSTD_outBuffer out{into.data(), into.size(), 0};
    while (out.pos == 0) {
      job_.progress.check_cancelled();
      // A frame's header may be spread over several reads.
      packed_.fill(at_frame_end_ ? ZSTD_FRAMEHEADERSIZE_MAX : 1);
      if (packed_.left().empty()) {
        if (at_frame_end_) return 0;
        damaged("ends", 0);
      }
      if (at_frame_end_) {
        reserve_window();
        wanted_ = ZSTD_FRAMEHEADERSIZE_MAX;
      }
      // No more than the decoder asks for, which is a block: where one is damaged, that tells its
      // place.
      ZSTD_inBuffer in{packed_.left().data(), std::min(packed_.left().size(), wanted_), 0};
      const std::size_t state = ZSTD_decompressStream(decoder_.get(), &out, &in);
      if (ZSTD_isError(state) != 0) damaged("breaks", out.pos);
      packed_.pass_over(in.pos);
      at_frame_end_ = state == 0;
      wanted_ = state;
    }
    return out.pos;
  }

  // The decoder keeps as much history as the frame's header asks for (8 MiB at zstd's highest usual
  // level, 128 MiB with its --long): the budget has to know.
  void reserve_window() {
    ZSTD_frameHeader header{};
    if (ZSTD_getFrameHeader(&header, packed_.left().data(), packed_.left().size()) != 0) return;
    if (header.windowSize <= window_.bytes()) return;
    window_ = {};
    window_ = job_.budget.reserve(header.windowSize, "decompressing this zstd content");
  }

  Reservation window_;
  std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> decoder_;
  std::size_t wanted_ = 0;
  bool at_frame_end_ = true;
};

}  // namespace

std::unique_ptr<ByteStream> decompress(Job& job, const std::string& name,
                                       const std::string& compression,
                                       std::unique_ptr<ByteStream> stream) {
  if (compression == "gzip") return std::make_unique<GzipStream>(job, name, std::move(stream));
  return std::make_unique<ZstdStream>(job, name, std::move(stream));
}

}  // namespace winnow
