#include "io/compressing.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#define ZSTD_STATIC_LINKING_ONLY  // for ZSTD_estimateCStreamSize
#include <zstd.h>

namespace winnow {

namespace bio = boost::iostreams;

namespace {

constexpr int zstd_level = 3;                      // the program's own default
constexpr std::uint64_t gzip_memory = 512 * 1024;  // zlib.h: 256 KiB for deflate, and buffers

class GzipCompressor final : public Compressor {
 public:
  explicit GzipCompressor(Job& job)
      : reserved_(job.budget.reserve(gzip_memory, "compressing the output")) {
    stream_.push(bio::gzip_compressor(bio::gzip_params(bio::gzip::default_compression), 1 << 16));
    stream_.push(bio::back_inserter(ready_));
  }

  void add(std::span<const std::byte> plain, std::vector<std::byte>& packed) override {
    stream_.sputn(reinterpret_cast<const char*>(plain.data()),
                  static_cast<std::streamsize>(plain.size()));
    hand_on(packed);
  }

  void finish(std::vector<std::byte>& packed) override {
    stream_.reset();
    hand_on(packed);
  }

 private:
  void hand_on(std::vector<std::byte>& packed) {
    const auto bytes = std::as_bytes(std::span(ready_));
    packed.insert(packed.end(), bytes.begin(), bytes.end());
    ready_.clear();
  }

  Reservation reserved_;
  std::vector<char> ready_;
  bio::filtering_streambuf<bio::output> stream_;
};

class ZstdCompressor final : public Compressor {
 public:
  explicit ZstdCompressor(Job& job)
      : reserved_(
            job.budget.reserve(ZSTD_estimateCStreamSize(zstd_level), "compressing the output")),
        encoder_(ZSTD_createCCtx(), ZSTD_freeCCtx),
        out_(ZSTD_CStreamOutSize()) {
    if (encoder_ == nullptr) throw Error(ErrorKind::resources, "no memory for a zstd encoder");
    ZSTD_CCtx_setParameter(encoder_.get(), ZSTD_c_compressionLevel, zstd_level);
    ZSTD_CCtx_setParameter(encoder_.get(), ZSTD_c_checksumFlag, 1);
  }

  void add(std::span<const std::byte> plain, std::vector<std::byte>& packed) override {
    ZSTD_inBuffer in{plain.data(), plain.size(), 0};
    while (in.pos < in.size) step(in, ZSTD_e_continue, packed);
  }

  void finish(std::vector<std::byte>& packed) override {
    ZSTD_inBuffer none{nullptr, 0, 0};
    while (step(none, ZSTD_e_end, packed) != 0) continue;
  }

 private:
  std::size_t step(ZSTD_inBuffer& in, ZSTD_EndDirective how, std::vector<std::byte>& packed) {
    ZSTD_outBuffer out{out_.data(), out_.size(), 0};
    const std::size_t left = ZSTD_compressStream2(encoder_.get(), &out, &in, how);
    if (ZSTD_isError(left) != 0)
      throw Error(ErrorKind::failed, std::string("cannot compress: ") + ZSTD_getErrorName(left));
    packed.insert(packed.end(), out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(out.pos));
    return left;
  }

  Reservation reserved_;
  std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> encoder_;
  std::vector<std::byte> out_;
};

// That of the name, in small letters; empty where it has none.
std::string_view compression_ending(std::string_view path) {
  for (const std::string_view ending : {".gz", ".zst"}) {
    if (path.size() >= ending.size() &&
        std::equal(ending.rbegin(), ending.rend(), path.rbegin(),
                   [](char known, char given) { return known == ascii_to_lower(given); }))
      return ending;
  }
  return {};
}

}  // namespace

std::string without_compression(const std::string& path) {
  return path.substr(0, path.size() - compression_ending(path).size());
}

std::unique_ptr<Compressor> make_compressor(Job& job, const std::string& path) {
  const std::string_view ending = compression_ending(path);
  if (ending == ".gz") return std::make_unique<GzipCompressor>(job);
  if (ending == ".zst") return std::make_unique<ZstdCompressor>(job);
  return nullptr;
}

}  // namespace winnow
