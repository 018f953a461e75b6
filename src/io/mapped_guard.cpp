#include "io/mapped_guard.hpp"

#include <winnow/error.hpp>
#include <winnow/mapped_guard.hpp>

#include <array>
#include <atomic>
#include <cstdint>

#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

namespace winnow {

namespace {

// A signal handler can reach nothing but globals, so here is the library's only one. A slot is free
// while `begin` is 0; the handler reads slots that other threads write, so every field is atomic.
struct Slot {
  std::atomic<std::uintptr_t> begin{0};
  std::atomic<std::uintptr_t> end{0};
  std::atomic<bool> hit{false};
};
std::array<Slot, 1024> slots;
std::atomic<bool> installed{false};
struct sigaction previous;
std::uintptr_t page_size = 4096;

void on_sigbus(int number, siginfo_t* info, void* machine) {
  const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
  for (Slot& slot : slots) {
    const std::uintptr_t begin = slot.begin.load();
    if (begin == 0 || address < begin || address >= slot.end.load()) continue;
    // A page of zeros in the place of the lost one lets the reader run on to where it asks
    // was_hit().
    void* page = reinterpret_cast<void*>(address & ~(page_size - 1));
    if (::mmap(page, page_size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) !=
        MAP_FAILED) {
      slot.hit = true;
      return;
    }
  }
  if ((previous.sa_flags & SA_SIGINFO) != 0 && previous.sa_sigaction != nullptr) {
    previous.sa_sigaction(number, info, machine);
  } else if (previous.sa_handler != SIG_DFL && previous.sa_handler != SIG_IGN) {
    previous.sa_handler(number);
  } else {
    ::signal(SIGBUS, SIG_DFL);  // the access runs again and ends the process as it would have
  }
}

}  // namespace

void guard_mapped_files() {
  if (installed.exchange(true)) return;
  page_size = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  struct sigaction action {};
  action.sa_sigaction = on_sigbus;
  action.sa_flags = SA_SIGINFO | SA_NODEFER;
  ::sigemptyset(&action.sa_mask);
  if (::sigaction(SIGBUS, &action, &previous) != 0) {
    installed = false;
    throw Error(ErrorKind::failed, "the system refused a SIGBUS handler");
  }
}

namespace mapped_guard {

int watch(const void* begin, std::size_t bytes) {
  const auto first = reinterpret_cast<std::uintptr_t>(begin);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    std::uintptr_t expected = 0;
    // Claimed with an address nothing can have, so that the handler matches it only once it is
    // complete.
    if (!slots[i].begin.compare_exchange_strong(expected, UINTPTR_MAX)) continue;
    slots[i].hit = false;
    slots[i].end = first + bytes;
    slots[i].begin = first;
    return static_cast<int>(i);
  }
  return -1;
}

void forget(int ticket) noexcept {
  if (ticket >= 0) slots[static_cast<std::size_t>(ticket)].begin = 0;
}

bool was_hit(int ticket) noexcept {
  return ticket >= 0 && slots[static_cast<std::size_t>(ticket)].hit;
}

}  // namespace mapped_guard

}  // namespace winnow
