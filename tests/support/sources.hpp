// Byte sources that tests make themselves: in memory, and through a pipe.
#pragma once

#include "io/byte_source.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <pthread.h>
#include <unistd.h>

namespace winnow::test {

// Every block is an allocation of its own, of just its size: sanitizers see whoever reads past it.
class MemorySource final : public ByteSource {
 public:
  enum class Kind { file, pipe };

  explicit MemorySource(std::string bytes, Kind kind = Kind::file, std::string name = "test")
      : ByteSource(std::move(name), ""), bytes_(std::move(bytes)), kind_(kind) {}

  Block take(std::size_t bytes) override {
    largest_take_ = std::max(largest_take_, bytes);
    const std::size_t length = std::min(bytes, bytes_.size() - at_);
    if (length == 0) return {};
    const std::shared_ptr<std::byte[]> copy(new std::byte[length]);
    std::memcpy(copy.get(), bytes_.data() + at_, length);
    Block block{{copy.get(), length}, at_, copy, nullptr};
    at_ += length;
    return block;
  }

  void give_back(std::size_t bytes) override {
    if (bytes > at_) throw std::logic_error("more given back than taken");
    at_ -= bytes;
  }

  [[nodiscard]] std::uint64_t position() const override { return at_; }
  [[nodiscard]] std::optional<std::uint64_t> size() const override {
    return seekable() ? std::optional<std::uint64_t>(bytes_.size()) : std::nullopt;
  }
  [[nodiscard]] bool seekable() const override { return kind_ == Kind::file; }
  void seek(std::uint64_t position) override {
    if (!seekable()) throw std::logic_error("a pipe cannot seek");
    at_ = std::min<std::size_t>(position, bytes_.size());
  }

  [[nodiscard]] std::size_t largest_take() const { return largest_take_; }

 private:
  std::string bytes_;
  Kind kind_;
  std::size_t at_ = 0;
  std::size_t largest_take_ = 0;
};

// A pipe whose other end is fed by a thread, in pieces of the given sizes (and then as they come).
class FedPipe {
 public:
  explicit FedPipe(std::string bytes, std::vector<std::size_t> pieces = {})
      : bytes_(std::move(bytes)), pieces_(std::move(pieces)) {
    if (::pipe(ends_.data()) != 0) throw std::runtime_error("no pipe");
    feeder_ = std::thread([this] { feed(); });
  }
  ~FedPipe() {
    ::close(ends_[0]);
    feeder_.join();
  }
  FedPipe(const FedPipe&) = delete;
  FedPipe& operator=(const FedPipe&) = delete;

  // To be opened once, while this object lives.
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(ends_[0]); }

 private:
  void feed() {
    // A reader that goes away early ends the feeding, not the process.
    sigset_t broken;
    sigemptyset(&broken);
    sigaddset(&broken, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &broken, nullptr);
    std::size_t piece = 0;
    for (std::size_t at = 0; at < bytes_.size();) {
      const std::size_t wanted = piece < pieces_.size() ? pieces_[piece++] : bytes_.size();
      const ssize_t done =
          ::write(ends_[1], bytes_.data() + at, std::min(wanted, bytes_.size() - at));
      if (done < 0) break;
      at += static_cast<std::size_t>(done);
    }
    ::close(ends_[1]);
  }

  std::string bytes_;
  std::vector<std::size_t> pieces_;
  std::array<int, 2> ends_{};
  std::thread feeder_;
};

inline std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
inline std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

}  // namespace winnow::test
