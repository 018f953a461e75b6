// Large zeroed memory that the budget knows of.
#pragma once

#include "base/budget.hpp"

#include <cstddef>
#include <span>

namespace winnow {

// Whole pages straight from the system: zeroed, resident only once touched, and really given back
// when they go, which the heap does not promise.
class Pages {
 public:
  Pages() = default;
  Pages(Reservation reservation, std::size_t bytes);  // the reservation must cover the bytes
  Pages(Pages&& other) noexcept;
  Pages& operator=(Pages&& other) noexcept;
  Pages(const Pages&) = delete;
  Pages& operator=(const Pages&) = delete;
  ~Pages();

  // Empty where the budget refuses.
  static Pages try_allocate(Budget& budget, std::size_t bytes);
  static Pages allocate(Budget& budget, std::size_t bytes, const char* what);

  explicit operator bool() const { return data_ != nullptr; }
  [[nodiscard]] std::byte* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }

  template <typename T>
  [[nodiscard]] std::span<T> as() const {
    return {reinterpret_cast<T*>(data_), size_ / sizeof(T)};
  }

  // Makes all of it resident at once, which is much cheaper than one fault a page where every page
  // is going to be written, here and there: reading a fresh page and then writing it even takes
  // two.
  void touch();

  void clear();  // zero again, by handing the pages back

 private:
  Reservation reservation_;
  std::byte* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace winnow
