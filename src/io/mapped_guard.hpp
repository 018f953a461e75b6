// The table that the SIGBUS handler of <winnow/mapped_guard.hpp> looks into.
#pragma once

#include <cstddef>

namespace winnow::mapped_guard {

int watch(const void* begin, std::size_t bytes);  // a ticket; -1 where the table is full
void forget(int ticket) noexcept;
bool was_hit(int ticket) noexcept;  // a page of this range was gone when it was read

}  // namespace winnow::mapped_guard
