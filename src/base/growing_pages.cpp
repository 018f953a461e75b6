#include "base/growing_pages.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <algorithm>
#include <utility>

#include <sys/mman.h>

namespace winnow {

namespace {
constexpr std::size_t step = std::size_t{64} << 10;

constexpr std::size_t round_up(std::size_t bytes) {
  return (bytes + step - 1) / step * step;
}
}  // namespace

GrowingPages::GrowingPages(Budget& budget, std::size_t limit)
    : budget_(&budget), limit_(limit / step * step) {
  if (limit_ == 0) return;
  void* memory =
      ::mmap(nullptr, limit_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) {
    throw Error(ErrorKind::resources, "the system refused addresses for " + human_bytes(limit_));
  }
  data_ = static_cast<std::byte*>(memory);
  ::madvise(memory, limit_, MADV_HUGEPAGE);  // fewer faults; a refusal costs nothing but speed
}

GrowingPages::GrowingPages(GrowingPages&& other) noexcept
    : budget_(other.budget_),
      data_(std::exchange(other.data_, nullptr)),
      limit_(std::exchange(other.limit_, 0)),
      usable_(std::exchange(other.usable_, 0)),
      reservations_(std::move(other.reservations_)) {}

GrowingPages& GrowingPages::operator=(GrowingPages&& other) noexcept {
  std::swap(budget_, other.budget_);
  std::swap(data_, other.data_);
  std::swap(limit_, other.limit_);
  std::swap(usable_, other.usable_);
  std::swap(reservations_, other.reservations_);
  return *this;
}

GrowingPages::~GrowingPages() {
  if (data_ != nullptr) ::munmap(data_, limit_);
}

bool GrowingPages::grow_to(std::size_t bytes) {
  if (bytes <= usable_) return true;
  if (bytes > limit_) return false;
  // An eighth more than asked, so that many small steps do not become many system calls.
  const std::size_t wanted = std::min(limit_, round_up(std::max(bytes, usable_ + usable_ / 8)));
  std::size_t target = wanted;
  Reservation reservation = budget_->try_reserve(target - usable_);
  if (!reservation) {
    target = round_up(bytes);
    reservation = budget_->try_reserve(target - usable_);
    if (!reservation) return false;
  }
  if (::mprotect(data_ + usable_, target - usable_, PROT_READ | PROT_WRITE) != 0) return false;
  // They are about to be written: one call is cheaper than a fault a page.
  ::madvise(data_ + usable_, target - usable_, MADV_POPULATE_WRITE);
  reservations_.push_back(std::move(reservation));
  usable_ = target;
  return true;
}

void GrowingPages::give_back() {
  if (usable_ == 0) return;
  ::madvise(data_, usable_, MADV_DONTNEED);
  ::mprotect(data_, usable_, PROT_NONE);
  usable_ = 0;
  reservations_.clear();
}

}  // namespace winnow
