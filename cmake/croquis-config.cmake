# SPDX-License-Identifier: GPL-3.0-or-later
# Found by find_package(croquis): what the libraries need, then the libraries themselves as croquis::NAME.
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/CroquisDependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/croquis-targets.cmake)
