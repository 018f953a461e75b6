#include "base/pages.hpp"

#include <winnow/error.hpp>

#include "base/page_memory.hpp"
#include "base/text.hpp"

#include <utility>

#include <sys/mman.h>

namespace winnow {

namespace {
constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::size_t large = 4 * huge_page;

void* map_pages(std::size_t bytes) {
  void* memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    throw Error(ErrorKind::resources, "the system refused " + human_bytes(bytes) + " of memory");
  }
  // Random access over megabytes is bound by address translation; a refusal costs nothing but
  // speed.
  if (bytes >= large) ::madvise(memory, bytes, MADV_HUGEPAGE);
  return memory;
}

class PageMemory final : public std::pmr::memory_resource {
  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    return bytes >= large ? map_pages(bytes)
                          : std::pmr::new_delete_resource()->allocate(bytes, alignment);
  }
  void do_deallocate(void* at, std::size_t bytes, std::size_t alignment) override {
    if (bytes >= large) {
      ::munmap(at, bytes);
    } else {
      std::pmr::new_delete_resource()->deallocate(at, bytes, alignment);
    }
  }
  [[nodiscard]] bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }
};

}  // namespace

Pages::Pages(Reservation reservation, std::size_t bytes)
    : reservation_(std::move(reservation)),
      data_(static_cast<std::byte*>(map_pages(bytes))),
      size_(bytes) {}

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

std::pmr::memory_resource* page_memory() {
  static PageMemory memory;
  return &memory;
}

}  // namespace winnow
