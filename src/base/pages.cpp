#include "base/pages.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <utility>

#include <sys/mman.h>

namespace winnow {

namespace {
constexpr std::size_t huge_page = std::size_t{2} << 20;
}

Pages::Pages(Reservation reservation, std::size_t bytes)
    : reservation_(std::move(reservation)), size_(bytes) {
  void* memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    throw Error(ErrorKind::resources, "the system refused " + human_bytes(bytes) + " of memory");
  }
  data_ = static_cast<std::byte*>(memory);
  // Random access over megabytes is bound by address translation; a refusal costs nothing but
  // speed.
  if (bytes >= 4 * huge_page) ::madvise(memory, bytes, MADV_HUGEPAGE);
}

Pages::Pages(Pages&& other) noexcept
    : reservation_(std::move(other.reservation_)),
      data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)) {}

Pages& Pages::operator=(Pages&& other) noexcept {
  std::swap(reservation_, other.reservation_);
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  return *this;
}

Pages::~Pages() {
  if (data_ != nullptr) ::munmap(data_, size_);
}

Pages Pages::try_allocate(Budget& budget, std::size_t bytes) {
  Reservation reservation = budget.try_reserve(bytes);
  if (!reservation) return {};
  return {std::move(reservation), bytes};
}

Pages Pages::allocate(Budget& budget, std::size_t bytes, const char* what) {
  return {budget.reserve(bytes, what), bytes};
}

void Pages::touch() {
  // A kernel before 5.14 refuses, and takes its faults.
  if (data_ != nullptr) ::madvise(data_, size_, MADV_POPULATE_WRITE);
}

void Pages::clear() {
  if (data_ != nullptr) ::madvise(data_, size_, MADV_DONTNEED);
}

}  // namespace winnow
