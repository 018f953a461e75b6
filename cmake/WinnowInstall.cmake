# Installs the program with its manual (component `program`), the shared library (component
# `library`), and the static one with the headers and the files that find_package(winnow) and
# pkg-config read (component `development`).
include(CMakePackageConfigHelpers)

install(TARGETS winnow winnow_shared EXPORT winnow-targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
                NAMELINK_COMPONENT development)
install(DIRECTORY include/winnow DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/include/winnow/version.hpp
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/winnow COMPONENT development)
if(WINNOW_CLI)
  install(TARGETS winnow_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/winnow)
configure_package_config_file(cmake/winnow-config.cmake.in ${PROJECT_BINARY_DIR}/winnow-config.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/winnow-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/winnow-config.cmake
        ${PROJECT_BINARY_DIR}/winnow-config-version.cmake
        DESTINATION ${package_dir} COMPONENT development)
install(EXPORT winnow-targets NAMESPACE winnow:: DESTINATION ${package_dir} COMPONENT development)

# Relative to where the file lies, so that an installation may be moved. Each part that was built
# has a file of its own, winnow-gltf.pc say.
file(RELATIVE_PATH prefix_from_pkgconfig /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
set(pkgconfig_files winnow)
set(pkgconfig_packages "")
set(pkgconfig_libraries "")
if(WINNOW_GLTF)
  string(APPEND pkgconfig_libraries " -lmeshoptimizer")
  list(APPEND pkgconfig_files winnow-gltf)
endif()
if(WINNOW_COMPARE)
  string(APPEND pkgconfig_packages " cairo")
  string(APPEND pkgconfig_libraries " -lembree3")
  list(APPEND pkgconfig_files winnow-compare)
endif()
configure_file(cmake/winnow.pc.in ${PROJECT_BINARY_DIR}/winnow.pc @ONLY)
foreach(part gltf compare)
  configure_file(cmake/winnow-part.pc.in ${PROJECT_BINARY_DIR}/winnow-${part}.pc @ONLY)
endforeach()
foreach(file IN LISTS pkgconfig_files)
  install(FILES ${PROJECT_BINARY_DIR}/${file}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT development)
endforeach()
