// A progressive file that the page shows: open, so that it may have no name any more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace winnow::viewer {

class ShownFile {
 public:
  // `shown`: what the page calls it. Throws Error(bad_input).
  ShownFile(const std::string& path, std::string shown);
  ~ShownFile();
  ShownFile(ShownFile&& other) noexcept;
  ShownFile& operator=(ShownFile&&) = delete;

  [[nodiscard]] const std::string& shown() const { return shown_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  // Fewer where the file was shortened meanwhile.
  [[nodiscard]] std::size_t read(std::uint64_t at, std::span<char> into) const;

 private:
  std::string shown_;
  int fd_ = -1;
  std::uint64_t bytes_ = 0;
};

}  // namespace winnow::viewer
