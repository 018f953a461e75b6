#include "base/budget.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

namespace winnow {

void Reservation::release() noexcept {
  if (budget_ != nullptr) budget_->used_.fetch_sub(bytes_, std::memory_order_relaxed);
  budget_ = nullptr;
  bytes_ = 0;
}

Reservation Budget::try_reserve(std::uint64_t bytes) {
  std::uint64_t used = used_.load(std::memory_order_relaxed);
  do {
    if (bytes > total_ - used) return {};
  } while (!used_.compare_exchange_weak(used, used + bytes, std::memory_order_relaxed));
  return {this, bytes};
}

Reservation Budget::reserve(std::uint64_t bytes, const char* what) {
  Reservation reservation = try_reserve(bytes);
  if (!reservation) {
    throw Error(ErrorKind::resources, std::string(what) + " needs " + human_bytes(bytes) +
                                          " more memory; " + human_bytes(left()) + " of " +
                                          human_bytes(total_) +
                                          " are left; the smallest that works is `memory` " +
                                          size_option(enough_for(bytes)));
  }
  return reservation;
}

std::uint64_t Budget::enough_for(std::uint64_t bytes) const {
  if (!held_) return used() + bytes + expected_;
  std::uint64_t total = total_;
  for (std::uint64_t needed = 0; (needed = bytes + held_(total)) > total;) {
    total = (needed + mebibyte - 1) / mebibyte * mebibyte;
  }
  return total;
}

}  // namespace winnow
