#include "io/compressed.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <array>
#include <cstring>
#include <exception>
#include <utility>

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#define ZSTD_STATIC_LINKING_ONLY  // for ZSTD_getFrameHeader
#include <zstd.h>

namespace winnow {

namespace bio = boost::iostreams;

std::string compression_of(std::span<const std::byte> head) {
  const auto starts = [&](std::initializer_list<unsigned char> magic) {
    return head.size() >= magic.size() && std::memcmp(head.data(), magic.begin(), magic.size()) == 0;
  };
  if (starts({0x1f, 0x8b})) return "gzip";
  if (starts({0x28, 0xb5, 0x2f, 0xfd})) return "zstd";
  return "";
}

namespace {

// Hands a ByteStream to Boost. Errors are kept aside: on their way through a streambuf they would be lost.
class StreamDevice {
 public:
  using char_type = char;
  using category = bio::source_tag;

  StreamDevice(ByteStream* stream, std::exception_ptr* failure) : stream_(stream), failure_(failure) {}

  std::streamsize read(char* into, std::streamsize length) {
    try {
      const std::size_t got =
          stream_->read(std::as_writable_bytes(std::span(into, static_cast<std::size_t>(length))));
      return got == 0 ? -1 : static_cast<std::streamsize>(got);
    } catch (...) {
      *failure_ = std::current_exception();
      throw;
    }
  }

 private:
  ByteStream* stream_;
  std::exception_ptr* failure_;
};

[[noreturn]] void damaged(const std::string& name, const char* compression, std::uint64_t at) {
  throw Error(ErrorKind::bad_input, "'" + name + "' is damaged or cut short: its " + compression +
                                        " content ends or breaks after " + grouped(at) +
                                        " bytes of plain content");
}

class GzipStream final : public ByteStream {
 public:
  GzipStream(std::string name, std::unique_ptr<ByteStream> stream)
      : name_(std::move(name)), stream_(std::move(stream)) {
    plain_.push(bio::gzip_decompressor(bio::zlib::default_window_bits, 1 << 16));
    plain_.push(StreamDevice(stream_.get(), &failure_), 1 << 16);
  }

  std::size_t read(std::span<std::byte> into) override {
    std::streamsize got = 0;
    try {
      got = plain_.sgetn(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(into.size()));
    } catch (const bio::gzip_error&) {
      fail();
    } catch (const std::ios_base::failure&) {
      fail();
    }
    if (failure_) std::rethrow_exception(failure_);
    position_ += static_cast<std::uint64_t>(got);
    return static_cast<std::size_t>(got);
  }

 private:
  [[noreturn]] void fail() {
    if (failure_) std::rethrow_exception(failure_);
    damaged(name_, "gzip", position_);
  }

  std::string name_;
  std::unique_ptr<ByteStream> stream_;
  std::exception_ptr failure_;
  bio::filtering_streambuf<bio::input> plain_;
  std::uint64_t position_ = 0;
};

// Boost's zstd filter takes the end of a cut file for the end of its content, and stops after the first of
// several frames; so the library is asked directly.
class ZstdStream final : public ByteStream {
 public:
  ZstdStream(Job& job, std::string name, std::unique_ptr<ByteStream> stream)
      : job_(job),
        name_(std::move(name)),
        stream_(std::move(stream)),
        decoder_(ZSTD_createDCtx(), ZSTD_freeDCtx) {
    if (decoder_ == nullptr) throw Error(ErrorKind::resources, "no memory for a zstd decoder");
    ZSTD_DCtx_setParameter(decoder_.get(), ZSTD_d_windowLogMax, ZSTD_WINDOWLOG_LIMIT_DEFAULT);
  }

  std::size_t read(std::span<std::byte> into) override {
    ZSTD_outBuffer out{into.data(), into.size(), 0};
    while (out.pos == 0) {
      if (packed_.pos == packed_.size) {
        packed_ = {buffer_.data(), stream_->read(buffer_), 0};
        if (packed_.size == 0) {
          if (!at_frame_end_) damaged(name_, "zstd", position_);
          return 0;
        }
      }
      if (at_frame_end_) {
        fill_header();
        reserve_window();
      }
      const std::size_t state = ZSTD_decompressStream(decoder_.get(), &out, &packed_);
      if (ZSTD_isError(state) != 0) damaged(name_, "zstd", position_);
      at_frame_end_ = state == 0;
    }
    position_ += out.pos;
    return out.pos;
  }

 private:
  // The decoder keeps as much history as the frame's header asks for (8 MiB at zstd's highest usual level,
  // 128 MiB with its --long): the budget has to know.
  void reserve_window() {
    ZSTD_frameHeader header{};
    const auto* at = static_cast<const std::byte*>(packed_.src) + packed_.pos;
    if (ZSTD_getFrameHeader(&header, at, packed_.size - packed_.pos) != 0) return;
    if (header.windowSize <= window_.bytes()) return;
    window_ = {};
    window_ = job_.budget.reserve(header.windowSize, "decompressing this zstd content");
  }

  // A frame's header may be spread over several reads.
  void fill_header() {
    std::size_t rest = packed_.size - packed_.pos;
    if (rest >= ZSTD_FRAMEHEADERSIZE_MAX) return;
    std::memmove(buffer_.data(), static_cast<const std::byte*>(packed_.src) + packed_.pos, rest);
    while (rest < ZSTD_FRAMEHEADERSIZE_MAX) {
      const std::size_t got = stream_->read(std::span(buffer_).subspan(rest));
      if (got == 0) break;
      rest += got;
    }
    packed_ = {buffer_.data(), rest, 0};
  }

  Job& job_;
  std::string name_;
  Reservation window_;
  std::unique_ptr<ByteStream> stream_;
  std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> decoder_;
  std::vector<std::byte> buffer_ = std::vector<std::byte>(std::size_t{1} << 17);
  ZSTD_inBuffer packed_{nullptr, 0, 0};
  std::uint64_t position_ = 0;
  bool at_frame_end_ = true;
};

}  // namespace

std::unique_ptr<ByteStream> decompress(Job& job, const std::string& name, const std::string& compression,
                                       std::unique_ptr<ByteStream> stream) {
  if (compression == "gzip") return std::make_unique<GzipStream>(name, std::move(stream));
  return std::make_unique<ZstdStream>(job, name, std::move(stream));
}

}  // namespace winnow
