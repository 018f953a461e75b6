// Whether the tests run under a sanitizer, which makes everything slow and large.
#pragma once

namespace winnow::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

// Every second that a promise speaks of is multiplied by this.
inline constexpr double patience = sanitized ? 10 : 1;

}  // namespace winnow::test
