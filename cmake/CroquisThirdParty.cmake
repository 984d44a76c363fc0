# SPDX-License-Identifier: GPL-3.0-or-later
# Every library the project uses is found here or in CroquisDependencies.cmake, once. Which Debian package brings which:
# scripts/packages; tests/scripts compares the two.

include(CroquisDependencies)

find_package(CLI11 REQUIRED CONFIG)

set(CROQUIS_HAS_OCCT FALSE)
if(NOT CROQUIS_WITH_OCCT STREQUAL "OFF")
  # Its config accepts no version but the very same, so none is asked for.
  find_package(OpenCASCADE QUIET CONFIG)
  if(OpenCASCADE_FOUND AND OpenCASCADE_VERSION VERSION_GREATER_EQUAL 7.6)
    set(CROQUIS_HAS_OCCT TRUE)
    # Its own targets ask for the development files of what it is made of; these link the libraries alone.
    add_library(croquis_occt INTERFACE)
    target_include_directories(croquis_occt SYSTEM INTERFACE ${OpenCASCADE_INCLUDE_DIR})
    foreach(part TKSTEP TKSTEPBase TKXSBase TKTopAlgo TKGeomBase TKBRep TKG3d TKG2d TKMath TKernel)
      find_library(CROQUIS_OCCT_${part} ${part} HINTS ${OpenCASCADE_LIBRARY_DIR} REQUIRED)
      mark_as_advanced(CROQUIS_OCCT_${part})
      target_link_libraries(croquis_occt INTERFACE ${CROQUIS_OCCT_${part}})
    endforeach()
  elseif(NOT CROQUIS_WITH_OCCT STREQUAL "AUTO")
    message(FATAL_ERROR "CROQUIS_WITH_OCCT is ON, but there is no OpenCASCADE 7.6: install libocct-data-exchange-dev "
                        "(scripts/setup step), or set it to AUTO or OFF.")
  endif()
endif()
message(STATUS "STEP files: ${CROQUIS_HAS_OCCT}")

if(CROQUIS_BUILD_APP)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets OpenGLWidgets Svg)
endif()

if(CROQUIS_BUILD_TESTS)
  find_package(Catch2 2.13 REQUIRED CONFIG)
  include(Catch)
  find_package(glfw3 3.3 REQUIRED CONFIG)
  if(CROQUIS_BUILD_APP)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Test)
  endif()
endif()
