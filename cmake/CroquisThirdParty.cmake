# SPDX-License-Identifier: GPL-3.0-or-later
# Every library the project uses is found here or in CroquisDependencies.cmake, once. Which Debian package brings which:
# scripts/packages; tests/scripts compares the two.

include(CroquisDependencies)

find_package(CLI11 REQUIRED CONFIG)

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
