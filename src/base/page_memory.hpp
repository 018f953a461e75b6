// Memory for large arrays that are accessed in any order.
#pragma once

#include <memory_resource>

namespace winnow {

// Large arrays are whole pages, huge where the system has such. What the budget holds for them is
// up to the caller.
std::pmr::memory_resource* page_memory();

}  // namespace winnow
