# Flags that every target of the project shares.

# The same bytes on every machine: no fused multiply-add, no reassociation; char has a sign. Traps
# and errno are not looked at, which lets loops vectorise without changing a result.
add_library(winnow_flags INTERFACE)
target_compile_options(winnow_flags INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math
                       -fsigned-char)
target_compile_options(winnow_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       -Wnon-virtual-dtor)
# A new value of an enumeration must not fall through a switch.
target_compile_options(winnow_flags INTERFACE -Werror=switch)
# Sources compiled as one are not meant to know each other's names.
if(WINNOW_UNITY)
  target_compile_options(winnow_flags INTERFACE -Wno-shadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(winnow_flags INTERFACE -Wshadow=local)
  endif()
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms on std::string (GCC bug 105329).
  target_compile_options(winnow_flags INTERFACE -Wno-restrict)
endif()
if(WINNOW_WARNINGS_AS_ERRORS)
  target_compile_options(winnow_flags INTERFACE -Werror)
endif()
