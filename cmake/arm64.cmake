# Builds for arm64 on another machine: with Debian's cross compiler, the libraries in
# WINNOW_SYSROOT and, for what the build itself runs, QEMU. tools/check-arm64 lays all that out.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc-12)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++-12)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES WINNOW_SYSROOT)
set(CMAKE_SYSROOT ${WINNOW_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${WINNOW_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR}
    ${WINNOW_SYSROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${WINNOW_SYSROOT}/usr/share/pkgconfig)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L ${WINNOW_SYSROOT})
