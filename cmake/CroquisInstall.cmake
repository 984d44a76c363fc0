# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install build/release --prefix DIR`: the programs, the libraries with their public headers, and a CMake package,
# so that a project outside says `find_package(croquis)` and links `croquis::silhouette` (tests/outside is one).

include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/croquis)
install(TARGETS croquis-cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(CROQUIS_BUILD_APP)
  install(TARGETS croquis RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(EXPORT croquis-targets NAMESPACE croquis:: DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/croquis-config-version.cmake COMPATIBILITY SameMinorVersion)
install(
  FILES
    ${PROJECT_BINARY_DIR}/croquis-config-version.cmake
    ${PROJECT_SOURCE_DIR}/cmake/croquis-config.cmake
    ${PROJECT_SOURCE_DIR}/cmake/CroquisDependencies.cmake
    ${PROJECT_SOURCE_DIR}/cmake/FindGLPK.cmake
    ${PROJECT_SOURCE_DIR}/cmake/FindOpenSubdiv.cmake
  DESTINATION ${package_folder})
