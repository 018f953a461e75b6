// Memory in scratch files, for arrays that are touched in any order and that the budget has no room
// for.
#pragma once

#include <winnow/error.hpp>

#include "io/job.hpp"
#include "io/scratch.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <memory_resource>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace winnow {

// Files are mapped: the system reads and writes their pages. What of them is in memory counts, so
// it is given back now and then. Not checked against damage, unlike other scratch.
class ScratchMemory final : public std::pmr::memory_resource {
 public:
  // `resident`: about so many bytes may be in memory at a time.
  ScratchMemory(Job& job, std::uint64_t resident)
      : job_(job),
        resident_(resident),
        reserved_(job.budget.reserve(resident, "pages of scratch")) {}
  ScratchMemory(const ScratchMemory&) = delete;
  ScratchMemory& operator=(const ScratchMemory&) = delete;
  ~ScratchMemory() override {
    for (const auto& [at, array] : arrays_) ::munmap(at, array.bytes);
  }

  // To be called whenever some hundred pages may have been touched.
  void give_back() {
    if (shared_bytes() < resident_ / 2) return;
    for (const auto& [at, array] : arrays_) ::madvise(at, array.bytes, MADV_DONTNEED);
  }

 private:
  struct Array {
    std::size_t bytes;
    std::unique_ptr<ScratchFile> file;
  };

  void* do_allocate(std::size_t bytes, std::size_t /*alignment*/) override {
    auto file = std::make_unique<ScratchFile>(job_.scratch, ScratchFile::Checked::no);
    // Written, so that there is room on the disk when it is touched.
    static constexpr std::array<std::byte, scratch_write_bytes> zeros{};
    for (std::size_t left = bytes; left > 0;) {
      const std::size_t part = std::min(left, zeros.size());
      job_.progress.check_cancelled();
      file->append(std::span(zeros).first(part));
      left -= part;
    }
    const int fd = ::open(file->path().c_str(), O_RDWR | O_CLOEXEC);
    void* const at =
        fd < 0 ? MAP_FAILED : ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    if (fd >= 0) ::close(fd);
    if (at == MAP_FAILED)
      throw Error(ErrorKind::resources, "cannot map scratch in '" + job_.scratch.directory() +
                                            "'; name another directory with `scratch`");
    arrays_.emplace(at, Array{bytes, std::move(file)});
    return at;
  }
  void do_deallocate(void* at, std::size_t bytes, std::size_t /*alignment*/) override {
    ::munmap(at, bytes);
    arrays_.erase(at);
  }
  [[nodiscard]] bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }

  // Of mapped files in memory.
  static std::uint64_t shared_bytes() {
    std::uint64_t all = 0, resident = 0, shared = 0;
    std::FILE* const file = std::fopen("/proc/self/statm", "re");
    if (file == nullptr) return UINT64_MAX;
    const int read = std::fscanf(file, "%lu %lu %lu", &all, &resident, &shared);
    std::fclose(file);
    return read == 3 ? shared * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) : UINT64_MAX;
  }

  Job& job_;
  std::uint64_t resident_;
  Reservation reserved_;
  std::map<void*, Array> arrays_;
};

}  // namespace winnow
