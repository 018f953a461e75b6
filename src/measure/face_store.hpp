// Faces in memory, with their numbers.
#pragma once

#include "base/growing_pages.hpp"
#include "io/job.hpp"
#include "read/good_faces.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>

namespace winnow {

// Faces that come from any thread, kept side by side; in the order of their numbers once sorted.
class FaceStore {
 public:
  // Room for so many `faces`; the budget is asked for it as they come.
  FaceStore(Budget& budget, std::uint64_t faces);

  // From any thread; false where there is no more room.
  bool add(std::span<const NumberedFace> faces);
  void sort(Job& job);
  void clear() { count_ = 0; }

  [[nodiscard]] std::span<NumberedFace> span() const;
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::size_t room() const { return pages_.limit() / sizeof(NumberedFace); }

 private:
  std::mutex mutex_;
  GrowingPages pages_;
  std::atomic<std::size_t> count_ = 0;
};

}  // namespace winnow
