# SPDX-License-Identifier: GPL-3.0-or-later
# Debian's own config of OpenSubdiv names a static library that no package ships and stops the configuration; this makes
# the imported target OpenSubdiv::osdCPU (Far and Sdc, no GPU code).
find_path(OpenSubdiv_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
find_library(OpenSubdiv_LIBRARY osdCPU)
if(OpenSubdiv_INCLUDE_DIR)
  file(STRINGS ${OpenSubdiv_INCLUDE_DIR}/opensubdiv/version.h OpenSubdiv_version_line REGEX "define OPENSUBDIV_VERSION v")
  string(REGEX REPLACE ".*v([0-9]+)_([0-9]+)_([0-9]+).*" "\\1.\\2.\\3" OpenSubdiv_VERSION "${OpenSubdiv_version_line}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenSubdiv
  REQUIRED_VARS OpenSubdiv_LIBRARY OpenSubdiv_INCLUDE_DIR
  VERSION_VAR OpenSubdiv_VERSION)
if(OpenSubdiv_FOUND AND NOT TARGET OpenSubdiv::osdCPU)
  add_library(OpenSubdiv::osdCPU UNKNOWN IMPORTED)
  set_target_properties(OpenSubdiv::osdCPU PROPERTIES
    IMPORTED_LOCATION "${OpenSubdiv_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenSubdiv_INCLUDE_DIR}")
endif()
