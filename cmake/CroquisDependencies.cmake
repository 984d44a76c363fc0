# SPDX-License-Identifier: GPL-3.0-or-later
# What the libraries below the hosts are made of. Read when Croquis is built, and installed beside croquis-config.cmake,
# so that a project which uses the libraries finds the same. Why each was chosen: docs/third-party.md.

find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)

set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5.5 REQUIRED)
# Debian's OpenMesh config names no version, so none can be asked for.
find_package(OpenMesh REQUIRED CONFIG)
find_package(GLPK REQUIRED)
find_package(OpenSubdiv 3.5 REQUIRED)

find_package(glm REQUIRED CONFIG)
find_package(nlohmann_json 3.11 REQUIRED CONFIG)
find_package(TinyGLTF REQUIRED CONFIG)
find_package(PNG REQUIRED)
pkg_check_modules(pugixml REQUIRED IMPORTED_TARGET pugixml)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(egl REQUIRED IMPORTED_TARGET egl)
pkg_check_modules(sqlite REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)
