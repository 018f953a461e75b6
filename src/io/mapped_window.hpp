// A part of a file as memory.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>

namespace winnow {

// Read-only. Its pages leave the resident set when it goes (Boost's advise() would not do that: it
// calls posix_madvise, whose DONTNEED the C library ignores).
class MappedWindow {
 public:
  MappedWindow(const boost::interprocess::file_mapping& file, std::uint64_t offset,
               std::size_t bytes);
  MappedWindow(const MappedWindow&) = delete;
  MappedWindow& operator=(const MappedWindow&) = delete;
  ~MappedWindow();

  [[nodiscard]] const std::byte* data() const {
    return static_cast<const std::byte*>(region_.get_address());
  }
  [[nodiscard]] std::size_t size() const { return region_.get_size(); }

  void drop_pages() const;  // takes every page out of the resident set; they can be touched again
  [[nodiscard]] bool damaged()
      const;  // the file shrank under the window: what was read is not to be trusted

 private:
  boost::interprocess::mapped_region region_;
  int guard_ = -1;
};

// Maps `path`; throws Error(bad_input).
boost::interprocess::file_mapping map_file(const std::string& path);

}  // namespace winnow
