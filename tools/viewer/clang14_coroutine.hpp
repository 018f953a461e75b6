// Clang 14 looks for coroutines where they were before C++20.
#pragma once

#include <coroutine>

namespace std::experimental {
using std::coroutine_handle;
using std::coroutine_traits;
}  // namespace std::experimental
