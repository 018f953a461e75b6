// Contiguous memory that grows inside the budget without ever moving.
#pragma once

#include "base/budget.hpp"

#include <cstddef>
#include <vector>

namespace winnow {

class GrowingPages {
 public:
  GrowingPages() = default;
  // Takes addresses for `limit` bytes, but no memory yet.
  GrowingPages(Budget& budget, std::size_t limit);
  GrowingPages(GrowingPages&& other) noexcept;
  GrowingPages& operator=(GrowingPages&& other) noexcept;
  GrowingPages(const GrowingPages&) = delete;
  GrowingPages& operator=(const GrowingPages&) = delete;
  ~GrowingPages();

  // Makes the first `bytes` usable; false where the limit or the budget refuses.
  [[nodiscard]] bool grow_to(std::size_t bytes);

  void give_back();  // all memory, but not the addresses

  [[nodiscard]] std::byte* data() const { return data_; }
  [[nodiscard]] std::size_t usable() const { return usable_; }
  [[nodiscard]] std::size_t limit() const { return limit_; }

 private:
  Budget* budget_ = nullptr;
  std::byte* data_ = nullptr;
  std::size_t limit_ = 0;
  std::size_t usable_ = 0;
  std::vector<Reservation> reservations_;
};

}  // namespace winnow
