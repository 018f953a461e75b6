#include "io/packed_blocks.hpp"

#include <winnow/error.hpp>

#include <array>
#include <cstring>

#include <zstd.h>

namespace winnow {

namespace {

constexpr std::size_t most_plain = std::size_t{1} << 16;  // bytes a block

struct BlockHead {
  std::uint32_t packed, plain;
};

// One decoder a thread is enough for any number of files: blocks are independent of each other.
ZSTD_DCtx* decoder() {
  thread_local const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(),
                                                                                  ZSTD_freeDCtx);
  return context.get();
}

}  // namespace

struct PackedFile::Encoder {
  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context{ZSTD_createCCtx(), ZSTD_freeCCtx};
};

PackedFile::PackedFile(Job& job)
    : file_(job.scratch, ScratchFile::Checked::no), encoder_(std::make_unique<Encoder>()) {
  if (encoder_->context == nullptr)
    throw Error(ErrorKind::resources, "no memory for a zstd encoder");
  ZSTD_CCtx_setParameter(encoder_->context.get(), ZSTD_c_compressionLevel, 1);
  ZSTD_CCtx_setParameter(encoder_->context.get(), ZSTD_c_checksumFlag, 1);
  pending_.reserve(scratch_write_bytes);
}

PackedFile::~PackedFile() = default;

void PackedFile::append(std::span<const std::byte> block) {
  const std::size_t bound = ZSTD_compressBound(block.size());
  if (pending_.size() + sizeof(BlockHead) + bound > scratch_write_bytes) flush();
  const std::size_t at = pending_.size();
  pending_.resize(at + sizeof(BlockHead) + bound);
  const std::size_t packed =
      ZSTD_compress2(encoder_->context.get(), pending_.data() + at + sizeof(BlockHead), bound,
                     block.data(), block.size());
  if (ZSTD_isError(packed) != 0) throw Error(ErrorKind::failed, "zstd failed on a scratch block");
  const BlockHead head{static_cast<std::uint32_t>(packed),
                       static_cast<std::uint32_t>(block.size())};
  std::memcpy(pending_.data() + at, &head, sizeof head);
  pending_.resize(at + sizeof head + packed);
}

void PackedFile::flush() {
  file_.append(pending_);
  pending_.clear();
}

void PackedFile::finish() {
  flush();
  pending_ = {};
  encoder_.reset();
}

PackedReader::PackedReader(const PackedFile& file) : file_(file.file_) {}
PackedReader::~PackedReader() = default;

bool PackedReader::next(std::vector<std::byte>& block) {
  if (at_ == file_.size()) return false;
  BlockHead head{};
  file_.read(at_, std::as_writable_bytes(std::span(&head, 1)));
  if (head.plain == 0 || head.plain > most_plain || head.packed == 0 ||
      head.packed > ZSTD_COMPRESSBOUND(most_plain))
    file_.damaged();
  packed_.resize(head.packed);
  file_.read(at_ + sizeof head, packed_);
  at_ += sizeof head + head.packed;
  block.resize(head.plain);
  const std::size_t plain =
      ZSTD_decompressDCtx(decoder(), block.data(), block.size(), packed_.data(), packed_.size());
  if (plain != block.size()) file_.damaged();
  return true;
}

}  // namespace winnow
