# Installs the library, its headers and the package files that find_package(winnow) reads.
include(CMakePackageConfigHelpers)

install(TARGETS winnow EXPORT winnow-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/winnow DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_BINARY_DIR}/include/winnow/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/winnow)
if(WINNOW_CLI)
  install(TARGETS winnow_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/winnow)
configure_package_config_file(cmake/winnow-config.cmake.in ${PROJECT_BINARY_DIR}/winnow-config.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/winnow-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/winnow-config.cmake ${PROJECT_BINARY_DIR}/winnow-config-version.cmake
        DESTINATION ${package_dir})
install(EXPORT winnow-targets NAMESPACE winnow:: DESTINATION ${package_dir})
