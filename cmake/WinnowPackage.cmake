# Debian packages: cpack -G DEB makes `winnow`, the program, `libwinnow0`, the shared library,
# `libwinnow-dev`, what programs are built with, and with WINNOW_PYTHON `python3-winnow`.
set(CPACK_PACKAGE_CONTACT "The winnow developers <winnow@packages.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL library development)
if(WINNOW_CLI)
  list(PREPEND CPACK_COMPONENTS_ALL program)
endif()

if(WINNOW_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME winnow)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
string(CONCAT CPACK_COMPONENT_PROGRAM_DESCRIPTION
       "Reads a triangle mesh of any size from front to back, and writes a small\n"
       "one as PLY, STL, OBJ, OFF, .m or GLB. Memory stays within a budget, and the\n"
       "result does not depend on it.")
# The program may be linked with it.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src)
if(BUILD_SHARED_LIBS)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libwinnow0 (= ${PROJECT_VERSION})")
endif()
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libwinnow0)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
file(WRITE ${PROJECT_BINARY_DIR}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/triggers)
string(CONCAT CPACK_COMPONENT_LIBRARY_DESCRIPTION
       "The library that the program winnow is made of, for programs that were\n"
       "built with libwinnow-dev.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libwinnow-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(development_packages "libwinnow0 (= ${PROJECT_VERSION})" libtbb-dev libboost-iostreams-dev
    libzstd-dev zlib1g-dev)
if(WINNOW_GLTF)
  list(APPEND development_packages libmeshoptimizer-dev)
endif()
if(WINNOW_COMPARE)
  list(APPEND development_packages libembree-dev libcairo2-dev)
endif()
list(JOIN development_packages ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
string(CONCAT CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
       "The library that the program winnow is made of, to be linked into others,\n"
       "with its headers and what CMake and pkg-config read.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-winnow)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, python3-numpy")
string(CONCAT CPACK_COMPONENT_PYTHON_DESCRIPTION
       "The library that the program winnow is made of, for Python: arrays of numpy\n"
       "in, arrays out.")

# Debian's changelog, of this version alone.
string(TIMESTAMP package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
find_program(WINNOW_GZIP gzip REQUIRED)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/changelog @ONLY CONTENT
     "winnow (@PROJECT_VERSION@) unstable; urgency=medium

  * Version @PROJECT_VERSION@.

 -- @CPACK_PACKAGE_CONTACT@  @package_date@
")
execute_process(COMMAND ${WINNOW_GZIP} -9nkf ${PROJECT_BINARY_DIR}/changelog)

set(component_packages program/winnow library/libwinnow0 development/libwinnow-dev)
if(WINNOW_PYTHON)
  list(APPEND component_packages python/python3-winnow)
endif()
foreach(component_package IN LISTS component_packages)
  cmake_path(GET component_package PARENT_PATH component)
  cmake_path(GET component_package FILENAME package)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright
          COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/changelog.gz
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endforeach()
include(CPack)
